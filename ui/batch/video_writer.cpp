#include "ui/batch/video_writer.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/descriptor.h"
#include "core/base/file.h"

extern char** environ; // NOLINT(readability-redundant-declaration): not declared by every C library

namespace stretch::ui {

namespace {

namespace fs = std::filesystem;

/// How a kind of video is made: what stands in ffmpeg's command line between the pictures and the name.
struct VideoKind {
  const char* ending;
  std::vector<const char*> options;
  const char* soundCodec; ///< Empty: it has no sound.
};

// Players want an even number of pixels along each side.
const std::vector<VideoKind>& videoKinds() {
  static const std::vector<VideoKind> kinds{
      {".mp4",
       {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p",
        "-movflags", "+faststart", "-f", "mp4"},
       "aac"},
      {".webm",
       {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-pix_fmt",
        "yuv420p", "-f", "webm"},
       "libopus"},
      {".gif", {"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f", "gif"}, ""}};
  return kinds;
}

const VideoKind* kindOf(const fs::path& path) {
  const auto found = std::ranges::find_if(
      videoKinds(), [&](const VideoKind& kind) { return path.extension() == kind.ending; });
  return found == videoKinds().end() ? nullptr : &*found;
}

/// Adds the sound as a second input that lasts as long as the pictures: cut where it is longer, else silent.
void addSound(const FilmSound& sound, const VideoKind& kind, std::vector<std::string>& words) {
  const bool begins = sound.fromSeconds >= 0.0; // before the video does
  words.insert(words.end(),
               {begins ? "-ss" : "-itsoffset", fmt::format("{:.6f}", std::abs(sound.fromSeconds)), "-i",
                "file:" + sound.file.string(), "-map", "0:v", "-map", "1:a", "-af",
                fmt::format("volume={:.4f},apad", sound.volume), "-c:a", kind.soundCodec, "-flags:a",
                "+bitexact", "-shortest"});
}

std::vector<std::string> wordsFor(const VideoPlan& plan, const VideoKind& kind, const fs::path& part) {
  std::vector<std::string> words{"ffmpeg",
                                 "-hide_banner",
                                 "-loglevel",
                                 "error",
                                 "-xerror", // a disk that is full ends it, with an exit code
                                 "-y",
                                 "-f",
                                 "rawvideo",
                                 "-pixel_format",
                                 "rgba",
                                 "-video_size",
                                 fmt::format("{}x{}", plan.widthPixels, plan.heightPixels),
                                 "-framerate",
                                 fmt::format("{:.6g}", plan.framesPerSecond),
                                 "-i",
                                 "pipe:0"};
  if (plan.sound && *kind.soundCodec != '\0') {
    addSound(*plan.sound, kind, words);
  }
  words.insert(words.end(), kind.options.begin(), kind.options.end());
  // The same pictures give the same bytes.
  for (const char* const word : {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact"}) {
    words.insert(words.end() - 2, word);
  }
  words.push_back("file:" + part.string()); // a colon or a dash in a name is no protocol and no option
  return words;
}

// The part, empty and locked; where the folder takes none ffmpeg says so.
Descriptor lockedPart(const fs::path& part) {
  constexpr mode_t withoutMask = 0666;
  for (;;) {
    Descriptor file(open(part.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, withoutMask));
    struct stat found {};
    // Another program may have taken it for left over before it was locked.
    if (file.number() < 0 || flock(file.number(), LOCK_EX | LOCK_NB) != 0 ||
        fstat(file.number(), &found) != 0 || found.st_nlink > 0) {
      return file;
    }
  }
}

Error cannotStart(const fs::path& path, int reason) {
  return reason == ENOENT
             ? Error{"a video needs ffmpeg, which is not installed", path.string(),
                     "install it (apt install ffmpeg), or write pictures: -o picture.png --frames A:B"}
             : Error{"ffmpeg cannot be started", path.string(), "see whether it runs by itself"};
}

} // namespace

// What a child process holds: its input, and what it complained of.
struct VideoWriter::Process {
  fs::path path;
  fs::path part;         ///< Where ffmpeg writes until the video is whole.
  Descriptor lock;       ///< Of the part.
  std::size_t bytes = 0; ///< Of a picture.
  pid_t child = -1;
  int input = -1;
  int complaints = -1;

  Process() = default;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (child > 0) {
      kill(child, SIGKILL);
    }
    end();
    if (complaints >= 0) {
      close(complaints);
    }
    std::error_code ignored;
    if (!part.empty()) {
      fs::remove(part, ignored);
    }
  }

  /// Whether it went well.
  bool end() {
    if (input >= 0) {
      close(input);
      input = -1;
    }
    int state = -1;
    while (child > 0 && waitpid(child, &state, 0) < 0 && errno == EINTR) {
    }
    child = -1;
    return WIFEXITED(state) && WEXITSTATUS(state) == 0;
  }

  [[nodiscard]] Error problem() {
    end();
    std::array<char, 512> text{};
    const ssize_t length = pread(complaints, text.data(), text.size() - 1, 0);
    std::string line(text.data(), static_cast<std::size_t>(std::max<ssize_t>(0, length)));
    line = line.substr(0, line.find('\n'));
    return {"ffmpeg could not write it" + (line.empty() ? std::string() : ": " + line), path.string(),
            "choose another folder, size or kind of video"};
  }

  Status start(const std::vector<std::string>& words) {
    std::array<int, 2> ends{-1, -1};
    complaints = memfd_create("ffmpeg", MFD_CLOEXEC);
    if (complaints < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      return Error{"the system gives no pipe", path.string(), "close other programs"};
    }
    input = ends[0];
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) {
      arguments.push_back(const_cast<char*>(word.c_str())); // what posix_spawnp asks for
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, complaints, STDERR_FILENO);
    const int failed = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (failed != 0) {
      child = -1;
      return cannotStart(path, failed);
    }
    return Success{};
  }
};

bool isVideoName(const fs::path& path) {
  return kindOf(path) != nullptr;
}

VideoWriter::VideoWriter(std::unique_ptr<Process> process) : process_(std::move(process)) {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Result<VideoWriter> VideoWriter::open(const VideoPlan& plan) {
  const VideoKind* const kind = kindOf(plan.path);
  if (kind == nullptr) {
    return Error{"the name of a video ends in .mp4, .webm or .gif", plan.path.string(),
                 "give a name such as punch.mp4"};
  }
  auto process = std::make_unique<Process>();
  process->path = plan.path;
  process->bytes =
      4 * static_cast<std::size_t>(plan.widthPixels) * static_cast<std::size_t>(plan.heightPixels);
  process->part = plan.path;
  process->part.replace_filename(fmt::format("{}video-{}.tmp", partName, getpid()));
  removeLeftParts(plan.path.parent_path());
  process->lock = lockedPart(process->part);
  if (Status started = process->start(wordsFor(plan, *kind, process->part)); !started) {
    return started.error();
  }
  return VideoWriter(std::move(process));
}

Status VideoWriter::add(const Image& picture) {
  std::size_t sent = 0;
  while (sent < process_->bytes && picture.rgba.size() == process_->bytes) {
    // A child that is gone is an error here, not a signal.
    const ssize_t now =
        send(process_->input, picture.rgba.data() + sent, process_->bytes - sent, MSG_NOSIGNAL);
    if (now < 0 && errno != EINTR) {
      return process_->problem();
    }
    sent += static_cast<std::size_t>(std::max<ssize_t>(0, now));
  }
  return Success{};
}

Status VideoWriter::finish() {
  if (!process_->end()) {
    return process_->problem();
  }
  std::error_code failed;
  fs::rename(process_->part, process_->path, failed);
  if (failed) {
    return Error{"the video cannot be put there: " + failed.message(), process_->path.string(),
                 "choose another folder"};
  }
  return Success{};
}

} // namespace stretch::ui
