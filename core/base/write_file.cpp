#include <algorithm>
#include <cerrno>

#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/descriptor.h"
#include "core/base/file.h"
#include "core/base/file_series.h"

namespace stretch {

namespace {

namespace fs = std::filesystem;

std::string reasonOf(int error) {
  return error == 0 ? std::string() : std::generic_category().message(error);
}

Error cannotWrite(const fs::path& path, const std::string& reason) {
  return {"cannot be written" + (reason.empty() ? "" : " (" + reason + ")"), path.string(),
          "check that the folder is there, that you may write to it and that the disk has room"};
}

fs::path folderOfFile(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// A name beside the file that no other program and no other thread has. Names of a fixed length: the file's
// own may be as long as the system allows. Names are tried from number `first` on.
template <typename Make>
fs::path makeUnique(const fs::path& target, const char* beginning, std::size_t first, Make&& make) {
  constexpr std::size_t mostTries = 200000; // more than the longest series holds at once
  for (std::size_t i = first; i < first + mostTries; ++i) {
    fs::path name = folderOfFile(target) / fmt::format("{}{}-{}.tmp", beginning, ::getpid(), i);
    errno = 0;
    if (make(name)) {
      return name;
    }
    if (errno != EEXIST) {
      break;
    }
  }
  return {};
}

// A new file, locked where the disk knows locks; none where the system says why, or another program just
// found it without a lock.
Descriptor newPart(const fs::path& name) {
  constexpr mode_t withoutMask = 0666;
  Descriptor part(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, withoutMask));
  struct stat found {};
  if (part.number() >= 0 && ((::flock(part.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) ||
                             (::fstat(part.number(), &found) == 0 && found.st_nlink == 0))) {
    part.close();
    errno = EEXIST;
  }
  return part;
}

bool writeAll(int file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      return false;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
  return true;
}

// What was renamed has to survive a loss of power too. Systems that cannot bring a folder to the disk say so.
bool syncFolder(const fs::path& folder) {
  const Descriptor open(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return open.number() >= 0 && (::fsync(open.number()) == 0 || errno == EINVAL || errno == ENOTSUP);
}

// Where a chain of symbolic links ends, whether there is a file or not.
fs::path withoutLinks(fs::path path) {
  constexpr int longestChain = 40;
  std::error_code failure;
  for (int i = 0; i < longestChain && fs::is_symlink(path, failure); ++i) {
    const fs::path next = fs::read_symlink(path, failure);
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

// One save: files get their places one after the other; without `keep` all of it is taken back.
class Replacement {
public:
  Replacement() = default;
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  ~Replacement() { takeBack(); }

  Status makeFolders(const fs::path& folder) {
    std::error_code failure;
    if (folder.empty() || fs::is_directory(folder, failure)) {
      return Success{};
    }
    if (Status made = makeFolders(folder.parent_path()); !made) {
      return made;
    }
    if (!fs::create_directory(folder, failure)) {
      return cannotWrite(folder, failure.message());
    }
    folders_.push_back(folder);
    return Success{};
  }

  // The new content on the disk, under another name.
  Status write(const fs::path& target, std::span<const std::span<const std::uint8_t>> pieces) {
    Step step;
    step.target = target;
    step.temporary = makeUnique(target, partName, steps_.size(), [&](const fs::path& name) {
      step.part = newPart(name);
      return step.part.number() >= 0;
    });
    const int number = step.part.number();
    if (number < 0) {
      return cannotWrite(target, reasonOf(errno));
    }
    steps_.push_back(std::move(step));
    const bool done =
        takeRights(target, number) &&
        std::ranges::all_of(pieces, [&](const auto& bytes) { return writeAll(number, bytes); }) &&
        ::fsync(number) == 0;
    return done ? Status(Success{}) : Status(cannotWrite(target, reasonOf(errno)));
  }

  // Of what was written last; whoever holds another lock against removeLeftParts may give it up.
  void unlockLast() { steps_.back().part.close(); }

  // All into their places. The last one needs no way back: with it the save is done.
  Status moveIntoPlace() {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      Step& step = steps_[i];
      if (i + 1 < steps_.size() && !setAside(step, i)) {
        return cannotWrite(step.target, reasonOf(errno));
      }
      if (::rename(step.temporary.c_str(), step.target.c_str()) != 0) {
        return cannotWrite(step.target, reasonOf(errno));
      }
      step.isInPlace = true;
    }
    return Success{};
  }

  Status keep() {
    const std::vector<Step> done = std::exchange(steps_, {});
    folders_.clear();
    bool isSafe = true;
    for (const Step& step : done) {
      isSafe = syncFolder(folderOfFile(step.target)) && isSafe;
    }
    for (const Step& step : done) {
      remove(step.old);
    }
    return isSafe ? Status(Success{}) : Status(cannotWrite(done.back().target, reasonOf(EIO)));
  }

private:
  struct Step {
    fs::path target;
    fs::path temporary; ///< The new content, until it is in place.
    Descriptor part;    ///< Its lock.
    fs::path old;       ///< The content before, set aside; empty where there was none.
    bool isInPlace = false;
  };

  static void remove(const fs::path& path) {
    std::error_code ignored;
    if (!path.empty()) {
      fs::remove(path, ignored); // of folders only empty ones
    }
  }

  // Who may do what with the file before also holds for the new one; not every system knows owners.
  static bool takeRights(const fs::path& target, int file) {
    struct stat before {};
    if (::stat(target.c_str(), &before) != 0) {
      return errno == ENOENT;
    }
    if (::fchown(file, before.st_uid, before.st_gid) != 0 && errno != EPERM && errno != EINVAL) {
      return false;
    }
    constexpr mode_t permissions = 0777;
    return ::fchmod(file, before.st_mode & permissions) == 0 || errno == EPERM;
  }

  // A second name for the old content, or a copy where the disk knows no second names.
  static bool setAside(Step& step, std::size_t number) {
    std::error_code failure;
    if (!fs::exists(step.target, failure)) {
      return true;
    }
    step.old = makeUnique(step.target, ".stretch-engine-", number, [&](const fs::path& name) {
      if (::link(step.target.c_str(), name.c_str()) == 0 || errno == EEXIST) {
        return errno != EEXIST;
      }
      if (!fs::copy_file(step.target, name, failure) && failure != std::errc::file_exists) {
        remove(name);
      }
      errno = failure.value();
      return !failure;
    });
    return !step.old.empty();
  }

  void takeBack() {
    for (auto at = steps_.rbegin(); at != steps_.rend(); ++at) {
      const Step& step = *at;
      if (!step.isInPlace) {
        remove(step.temporary);
        remove(step.old);
      } else if (step.old.empty()) {
        remove(step.target);
      } else {
        std::error_code ignored; // then the old content stays under its other name
        fs::rename(step.old, step.target, ignored);
      }
    }
    for (auto folder = folders_.rbegin(); folder != folders_.rend(); ++folder) {
      remove(*folder);
    }
  }

  std::vector<Step> steps_;
  std::vector<fs::path> folders_;
};

// Whoever protected a file means it, although its folder would let it be replaced.
bool isProtected(const fs::path& target) {
  struct stat found {};
  constexpr mode_t anyoneWrites = 0222;
  return ::stat(target.c_str(), &found) == 0 && S_ISREG(found.st_mode) &&
         ((found.st_mode & anyoneWrites) == 0 || (::access(target.c_str(), W_OK) != 0 && errno == EACCES));
}

struct Content {
  fs::path path;
  std::vector<std::span<const std::uint8_t>> pieces;
};

// Another file may stand in the way of one, and a link leads to where it is written.
Status checkTarget(const fs::path& path, const fs::path& target) {
  std::error_code ignored;
  const fs::file_status before = fs::status(target, ignored);
  if (fs::exists(before) && !fs::is_regular_file(before) && !fs::is_directory(before)) {
    return Error{"is not a regular file", path.string(), "choose another name"};
  }
  if (isProtected(target)) {
    return Error{"is write-protected", path.string(), "take the protection away, or choose another name"};
  }
  return Success{};
}

Status writePart(Replacement& replacement, const Content& content) {
  const fs::path target = withoutLinks(content.path);
  const Status free = checkTarget(content.path, target);
  return free ? replacement.write(target, content.pieces) : free;
}

Status replaceAll(std::span<const Content> contents, MissingFolder folder) {
  Replacement replacement;
  for (const Content& content : contents) {
    if (folder == MissingFolder::isMade) {
      if (Status made = replacement.makeFolders(withoutLinks(content.path).parent_path()); !made) {
        return made;
      }
    }
    if (Status written = writePart(replacement, content); !written) {
      return written;
    }
  }
  if (Status moved = replacement.moveIntoPlace(); !moved) {
    return moved;
  }
  return contents.empty() ? Status(Success{}) : replacement.keep();
}

// A folder with a lock on it; where none is given, errno says why.
Descriptor lockedFolder(const fs::path& folder, int kind) {
  Descriptor open(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (open.number() >= 0 && ::flock(open.number(), kind) != 0) {
    const int reason = errno;
    open.close();
    errno = reason;
  }
  return open;
}

} // namespace

struct FileSeries::Parts {
  Descriptor folder; ///< Its lock keeps removeLeftParts away: so many files cannot hold one each.
  Replacement replacement;
};

FileSeries::FileSeries(const fs::path& folder) : parts_(std::make_unique<Parts>()) {
  removeLeftParts(folder);
  parts_->folder = lockedFolder(folder, LOCK_SH);
}
FileSeries::FileSeries(FileSeries&&) noexcept = default;
FileSeries::~FileSeries() = default;

Status FileSeries::add(const fs::path& path, std::span<const std::uint8_t> bytes) {
  Status written = writePart(parts_->replacement, {path, {bytes}});
  if (written && parts_->folder.number() >= 0) {
    parts_->replacement.unlockLast();
  }
  return written;
}

Status FileSeries::finish() {
  const Status moved = parts_->replacement.moveIntoPlace();
  return moved ? parts_->replacement.keep() : moved;
}

Status checkPlace(const fs::path& path) {
  const fs::path target = withoutLinks(path);
  const fs::path folder = folderOfFile(target);
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    return Error{"there is no such folder", folder.string(), "make it, or save elsewhere"};
  }
  if (fs::is_directory(target, ignored)) {
    return Error{"is a folder", path.string(), "choose another name"};
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    return cannotWrite(path, reasonOf(errno));
  }
  return checkTarget(path, target);
}

void removeLeftParts(const fs::path& folder) {
  std::error_code failure;
  const Descriptor held(lockedFolder(folder, LOCK_EX | LOCK_NB));
  if (held.number() < 0 && errno == EWOULDBLOCK) {
    return; // a series is being written: the parts of others are taken away the next time
  }
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const fs::path& path = entry->path();
    if (!path.filename().string().starts_with(partName) || path.extension() != ".tmp") {
      continue;
    }
    const Descriptor part(::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat locked {};
    struct stat named {};
    // A writer may have put it into its place, and begun another one of that name, before it was locked here.
    if (part.number() >= 0 && ::flock(part.number(), LOCK_EX | LOCK_NB) == 0 &&
        ::fstat(part.number(), &locked) == 0 && ::lstat(path.c_str(), &named) == 0 &&
        locked.st_ino == named.st_ino && locked.st_dev == named.st_dev) {
      ::unlink(path.c_str());
    }
  }
}

Status writeFiles(std::span<const OutputFile> files, MissingFolder folder) {
  std::vector<Content> contents;
  contents.reserve(files.size());
  for (const OutputFile& file : files) {
    contents.push_back({file.path, {file.bytes}});
    contents.back().pieces.insert(contents.back().pieces.end(), file.more.begin(), file.more.end());
  }
  return replaceAll(contents, folder);
}

Status writeFile(const fs::path& path, std::span<const std::uint8_t> bytes, MissingFolder folder) {
  const Content content{path, {bytes}};
  return replaceAll({&content, 1}, folder);
}

Status writeText(const fs::path& path, std::string_view text, MissingFolder folder) {
  return writeFile(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, folder);
}

} // namespace stretch
