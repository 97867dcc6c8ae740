#include "app/file_work.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "app/commands/pose/posing.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/files/save.h"

namespace stretch::app {

namespace {

namespace fs = std::filesystem;

constexpr double keepAsideAfterSeconds = 3.0;

template <typename... Cases>
struct Match : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Match(Cases...) -> Match<Cases...>;

void tellWarnings(FileUser& user, const std::vector<std::string>& warnings) {
  if (!warnings.empty()) {
    user.tell(Tone::warning, warnings.size() == 1
                                 ? warnings.front()
                                 : fmt::format("{} (and {} more)", warnings.front(), warnings.size() - 1));
  }
}

/// Empty where the file plays as it is seen; else how far it is off between the frames that alone got keys.
std::string missText(double missOfHeight) {
  return missOfHeight > 0.0
             ? fmt::format(": keys stand on whole frames; between them the motion is up to {:.2g} % of the "
                           "height off (Edit, Settings, Keys stand)",
                           100.0 * missOfHeight)
             : std::string();
}

// What is seen or set up, and not in the clips of the file that was written.
void tellLeftOut(FileUser& user, const Session& session) {
  if (const ViewState& view = session.view(); isPosedWithoutKey(view)) {
    user.tell(Tone::warning,
              fmt::format("The pose at frame {:g} has no key: it is not in the file. Key it, and save again.",
                          view.frame));
  }
  if (const std::size_t apart = disconnectedTrails(session.document()); apart > 0) {
    const bool one = apart == 1;
    user.tell(
        Tone::warning,
        fmt::format("{} {} disconnected: kept in the file, but the file plays without {}. Connect {} to "
                    "have {} played.",
                    apart, one ? "trail is" : "trails are", one ? "it" : "them", one ? "it" : "them",
                    one ? "it" : "them"));
  }
}

WorkPlace placeOf(const ViewState& view) {
  return {view.clip, view.frame, view.selection.limbs(), view.selection.trail()};
}

/// The clip that was worked on with its frame and selection; where nothing says so, the first with a trail.
void showWhereWorkWas(Session& session, const std::optional<WorkPlace>& where) {
  const Document& document = session.document();
  ViewState& view = session.view();
  const WorkPlace fallback{document.trails.empty() ? view.clip : document.trails.front().clip, 0.0, {}, 0};
  const WorkPlace& place = where ? *where : fallback;
  if (place.clip < 0 || place.clip >= static_cast<int>(document.clips->size())) {
    return;
  }
  view.clip = place.clip;
  view.frame = std::clamp(place.frame, 0.0, lastFrame(document, place.clip));
  view.selection.editTrails().limbs = place.limbs;
  std::erase_if(view.selection.editTrails().limbs,
                [&](const std::string& limb) { return findLimb(document, limb) == nullptr; });
  view.selection.dropSpheres();
  selectTrail(session, place.trail);
}

} // namespace

bool hasUnsavedWork(const OpenDocument& open) {
  if (const SequenceSession* const sequence = open.sequence()) {
    return !sequence->history().isSaved();
  }
  const Session* const session = open.character();
  if (session == nullptr || session->history().isSaved()) {
    return false;
  }
  // What it refers to is kept beside the file: another reference alone is no work.
  const Document* const saved = session->history().saved();
  const Document& current = session->history().current();
  return saved == nullptr || saved->references == current.references || !sameInFile(*saved, current);
}

bool wouldLoseWork(const OpenDocument& open) {
  const Session* const session = open.character();
  return hasUnsavedWork(open) || (session != nullptr && isPosedWithoutKey(session->view()));
}

std::string shownName(const fs::path& path) {
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

fs::path nextIncrement(const fs::path& path) {
  std::string stem = path.stem().string();
  const std::size_t dash = stem.rfind('-');
  constexpr std::size_t mostDigits = 6; // a longer one is a date
  const std::string digits = dash == std::string::npos ? std::string() : stem.substr(dash + 1);
  const bool numbered = !digits.empty() && digits.size() <= mostDigits &&
                        std::ranges::all_of(digits, [](unsigned char c) { return std::isdigit(c) != 0; });
  stem = numbered ? stem.substr(0, dash) : stem;
  const int own = numbered ? std::stoi(digits) : 0;
  fs::path next = path;
  std::error_code ignored;
  for (int number = own + 1; number < own + 100000; ++number) {
    next.replace_filename(fmt::format("{}-{:03}{}", stem, number, path.extension().string()));
    if (!fs::exists(next, ignored)) {
      break;
    }
  }
  return next;
}

FileQuestion FileWork::question() const {
  using Kind = FileQuestion::Kind;
  return std::visit(Match{[](const Idle&) { return FileQuestion{}; },
                          [](const AskingUnsaved&) {
                            return FileQuestion{Kind::unsaved, {}};
                          },
                          [](const AskingName&) {
                            return FileQuestion{Kind::name, {}};
                          },
                          [](const AskingOverwrite& asked) {
                            return FileQuestion{Kind::overwrite, asked.path};
                          },
                          [](const OfferingAutosave& offered) {
                            return FileQuestion{Kind::restore, offered.autosave.source};
                          }},
                    state_);
}

std::string FileWork::openingName() const {
  return opening_ ? shownName(opening_->paths.back()) : std::string();
}

float FileWork::openingShare() const {
  return opening_ ? opening_->share->load() : -1.0F;
}

bool FileWork::isKeptAside(const Session& session) const {
  return keptAside_ && keptAside_->place == placeOf(session.view()) &&
         sameDocument(keptAside_->document, session.document());
}

void FileWork::openFile(FileUser& user, const Paths& paths) {
  if (question().kind != FileQuestion::Kind::none) {
    user.tell(Tone::info, "Answer the question first");
  } else if (opening_) {
    user.tell(Tone::info, "Another file is being opened");
  } else if (wouldLoseWork(user.open())) {
    state_ = AskingUnsaved{OpenPaths{paths}};
  } else {
    start(user, paths, std::nullopt);
  }
}

void FileWork::start(FileUser& user, const Paths& paths, std::optional<fs::path> restoreFrom) {
  if (opening_) {
    user.tell(Tone::info, "Another file is being opened");
    return;
  }
  opening_.emplace();
  opening_->paths = paths;
  opening_->restoreFrom = std::move(restoreFrom);
  opening_->stamp = stampOf(paths.back());
  opening_->share = std::make_shared<std::atomic<float>>(-1.0F);
  give(user);
  opening_->work = std::async(std::launch::async, [load = loader_, paths, share = opening_->share] {
    return load(paths, [&share](double done) { *share = static_cast<float>(done); });
  });
}

// What is open now may be lost: the user was asked.
void FileWork::give(FileUser& user) {
  if (const SequenceSession* const sequence = user.open().sequence()) {
    opening_->givenSequence = sequence->history().current();
  }
  const Session* const open = user.open().character();
  if (open == nullptr) {
    return;
  }
  opening_->givenPose = open->view().unkeyed;
  if (hasUnsavedWork(user.open())) {
    opening_->given = open->history().current();
  }
}

/// Whether the user gave up what is open as it is now.
bool FileWork::isGiven(const OpenDocument& open) const {
  if (const SequenceSession* const sequence = open.sequence()) {
    return opening_->givenSequence && sameDocument(*opening_->givenSequence, sequence->history().current());
  }
  return opening_->given && sameDocument(*opening_->given, open.character()->history().current());
}

void FileWork::takeRead(FileUser& user) {
  if (opening_->work.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return;
  }
  Result<Opened> read = opening_->work.get();
  if (!read) {
    user.tell(Tone::error, openingName() + ": " + read.error().line());
    opening_.reset();
    return;
  }
  opening_->read = std::move(read).value();
}

/// Work that came after the user let the file be opened is asked for as well.
void FileWork::show(FileUser& user) {
  const Session* const open = user.open().character();
  const bool isNewPose =
      open != nullptr && isPosedWithoutKey(open->view()) && open->view().unkeyed != opening_->givenPose;
  if ((hasUnsavedWork(user.open()) && !isGiven(user.open())) || isNewPose) {
    state_ = AskingUnsaved{ShowRead{}};
    return;
  }
  Opening read = *std::exchange(opening_, std::nullopt);
  close(user);
  user.open().open(std::move(*read.read));
  Session* const session = user.open().character();
  path_ = session != nullptr ? read.paths.back() : pathOf(user.open().sequence()->document());
  if (session != nullptr) {
    stamp(path_, read.stamp);
    openedSource_ = session->document().source;
  } else {
    stampedPath_.clear(); // Nothing is saved over a sequence: changes by others do not matter.
    stamp_.reset();
  }
  user.opened();
  if (session == nullptr) {
    return;
  }
  tellWarnings(user, session->document().warnings);
  if (read.restoreFrom) {
    restore(user, *read.restoreFrom);
  } else {
    offerAutosave(path_);
  }
}

void FileWork::save(FileUser& user) {
  if (user.open().character() != nullptr) {
    saveThen(user, Nothing{});
  }
}

void FileWork::saveThen(FileUser& user, Next next) {
  const fs::path path = user.open().character()->savePath();
  if (path.empty()) {
    state_ = AskingName{std::move(next)};
  } else if (changedByOthers(path)) {
    state_ = AskingOverwrite{path, std::move(next)};
  } else {
    write(user, path, std::move(next));
  }
}

void FileWork::saveAs(FileUser& user, const fs::path& path) {
  if (user.open().character() == nullptr) {
    return;
  }
  const auto* const asked = std::get_if<AskingName>(&state_);
  write(user, path, asked != nullptr ? asked->next : Next{});
}

void FileWork::saveIncremental(FileUser& user) {
  if (const Session* const session = user.open().character()) {
    saveAs(user, nextIncrement(session->proposedSavePath()));
  }
}

void FileWork::write(FileUser& user, const fs::path& path, Next next) {
  state_ = Idle{};
  const bool isElsewhere = path != path_; // Each save of one file needs the same others.
  const Result<double> done = user.open().character()->save(path, false, user.form());
  if (!done) {
    user.tell(Tone::error, done.error().line());
    cancel();
    return;
  }
  user.tell(Tone::success, "Saved " + path.filename().string() + missText(*done));
  tellLeftOut(user, *user.open().character());
  if (isElsewhere) {
    tellWarnings(user, besideLines(*user.open().character()->document().source, path));
  }
  path_ = path; // What is open now: unsaved work from here on is kept aside for it.
  openedSource_ = user.open().character()->document().source;
  stamp(path, stampOf(path));
  forgetKeptAside();
  user.saved(path);
  goOn(user, next);
}

void FileWork::exportClean(FileUser& user, const fs::path& path) {
  Session* const session = user.open().character();
  if (session == nullptr) {
    return;
  }
  const Result<double> done = session->save(path, true, user.form());
  if (!done) {
    user.tell(Tone::error, done.error().line());
    return;
  }
  user.tell(Tone::success, "Exported " + path.filename().string() + missText(*done));
  tellLeftOut(user, *session);
  tellWarnings(user, besideLines(*session->document().source, path));
}

void FileWork::quit(FileUser& user) {
  if (wouldLoseWork(user.open())) {
    state_ = AskingUnsaved{Quit{}};
  } else {
    user.quit();
  }
}

void FileWork::goOn(FileUser& user, const Next& next) {
  state_ = Idle{};
  std::visit(Match{[](const Nothing&) {}, [&](const Quit&) { user.quit(); },
                   [&](const OpenPaths& wanted) { start(user, wanted.paths, std::nullopt); },
                   [&](const ShowRead&) {
                     give(user);
                     show(user);
                   }},
             next);
}

void FileWork::cancel() {
  state_ = Idle{};
  if (opening_ && opening_->read) {
    opening_.reset(); // What is open stays.
  }
}

void FileWork::answer(FileUser& user, FileAnswer answer) {
  const State asked = state_;
  if (const auto* unsaved = std::get_if<AskingUnsaved>(&asked)) {
    answerUnsaved(user, *unsaved, answer);
  } else if (const auto* overwrite = std::get_if<AskingOverwrite>(&asked)) {
    answerOverwrite(user, *overwrite, answer);
  } else if (const auto* offered = std::get_if<OfferingAutosave>(&asked)) {
    answerOffer(user, *offered, answer);
  } else if (std::holds_alternative<AskingName>(asked) && answer == FileAnswer::cancel) {
    cancel();
  }
}

void FileWork::answerUnsaved(FileUser& user, const AskingUnsaved& asked, FileAnswer answer) {
  if (answer == FileAnswer::cancel) {
    cancel();
  } else if (answer == FileAnswer::discard) {
    goOn(user, asked.next);
  } else if (answer == FileAnswer::save && user.open().character() != nullptr) {
    if (const Status keyed = keyUnkeyedPose(*user.open().character()); !keyed) {
      user.tell(Tone::error, keyed.error().line());
      cancel();
      return;
    }
    saveThen(user, asked.next);
  }
}

void FileWork::answerOverwrite(FileUser& user, const AskingOverwrite& asked, FileAnswer answer) {
  if (answer == FileAnswer::overwrite) {
    write(user, asked.path, asked.next);
  } else if (answer == FileAnswer::otherName) {
    state_ = AskingName{asked.next};
  } else if (answer == FileAnswer::cancel) {
    cancel();
  }
}

void FileWork::answerOffer(FileUser& user, const OfferingAutosave& offered, FileAnswer answer) {
  const bool isOpen = user.open().character() != nullptr && offered.autosave.source == path_;
  if (answer == FileAnswer::discard) {
    removeAutosave(offered.autosave.file);
    state_ = Idle{};
  } else if (answer == FileAnswer::restore) {
    state_ = Idle{};
    if (isOpen) {
      restore(user, offered.autosave.file);
    } else {
      start(user, {offered.autosave.source}, offered.autosave.file);
    }
  }
}

void FileWork::restore(FileUser& user, const fs::path& autosave) {
  Session& session = *user.open().character();
  Result<Document> restored = withAutosave(session.document(), autosave);
  const std::optional<WorkPlace> where = placeOfAutosave(autosave);
  if (!restored) { // A file that is put right, or another version of this program, may take it.
    user.tell(Tone::error,
              fmt::format("The unsaved work stays in {}: {}", autosave.string(), restored.error().line()));
    return;
  }
  removeAutosave(autosave);
  const std::vector<std::string>& before = session.document().warnings;
  std::vector<std::string> leftOut;
  std::ranges::copy_if(restored->warnings, std::back_inserter(leftOut), [&](const std::string& warning) {
    return std::ranges::find(before, warning) == before.end();
  });
  session.edit(std::move(restored).value(), "Restore unsaved work");
  showWhereWorkWas(session, where);
  user.tell(Tone::success,
            leftOut.empty() ? "The unsaved work is back" : "What fits of the unsaved work is back");
  tellWarnings(user, leftOut);
}

void FileWork::offerAutosave(const fs::path& file) {
  if (auto found = findAutosave(file)) {
    found->source = file.empty() ? found->source : file;
    state_ = OfferingAutosave{std::move(*found)};
  }
}

void FileWork::returned(FileUser& user) {
  if (!changeTold_ && changedByOthers(stampedPath_)) {
    changeTold_ = true;
    user.tell(Tone::warning, stampedPath_.filename().string() + " was changed by another program");
  }
}

void FileWork::update(FileUser& user, double nowSeconds) {
  if (opening_ && !opening_->read) {
    takeRead(user);
  }
  if (opening_ && opening_->read && std::holds_alternative<Idle>(state_)) {
    show(user);
  }
  keepAside(user, nowSeconds);
}

void FileWork::keepAside(FileUser& user, double nowSeconds) {
  const Session* const session = user.open().character();
  if (session == nullptr || session->isDragging()) {
    return;
  }
  if (!hasUnsavedWork(user.open())) {
    forgetKeptAside();
    return;
  }
  const Document& document = session->document();
  if (nowSeconds - keptAsideSeconds_ < keepAsideAfterSeconds || isKeptAside(*session)) {
    return;
  }
  keptAsideSeconds_ = nowSeconds;
  const fs::path file = autosavePath(path_);
  const WorkPlace place = placeOf(session->view());
  const bool isChanged = openedSource_ != nullptr && document.source != openedSource_;
  const bool isKept = keptAside_ && keptAside_->document.source == document.source;
  Status written = isChanged && !isKept ? keepSourceAside(*document.source, file) : Status(Success{});
  if (written) {
    written = writeText(file, autosaveText(document, place, path_, isChanged));
  }
  if (written) {
    keptAside_ = KeptAside{file, document, place};
  } else if (!keepFailureTold_) {
    user.tell(Tone::warning, "Unsaved work is not kept aside: " + written.error().line());
  }
  keepFailureTold_ = !written;
}

void FileWork::forgetKeptAside() {
  if (keptAside_) {
    removeAutosave(keptAside_->file);
    keptAside_.reset();
  }
}

void FileWork::close(FileUser& user) {
  if (!user.open().isEmpty()) {
    user.closing();
  }
  forgetKeptAside();
  keepFailureTold_ = false;
}

void FileWork::stamp(const fs::path& path, const std::optional<FileStamp>& stamp) {
  stampedPath_ = path;
  stamp_ = stamp;
  changeTold_ = false;
}

bool FileWork::changedByOthers(const fs::path& path) const {
  return !path.empty() && path == stampedPath_ && stamp_ && stampOf(path) != stamp_;
}

} // namespace stretch::app
