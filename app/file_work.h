#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/files/autosave.h"
#include "app/files/user_files.h"
#include "app/open_document.h"
#include "app/schema/saved_form.h"

namespace stretch::app {

enum class Tone { info, success, warning, error };

/// Question that is asked of the user about files; one question at a time.
struct FileQuestion {
  enum class Kind {
    none,
    unsaved,   ///< Work would be lost: save, discard or cancel? Of a sequence: discard or cancel?
    name,      ///< Asks for the file to save to. Answered by saveAs, or cancel.
    overwrite, ///< Another program changed the file: overwrite, otherName or cancel?
    restore    ///< Work was left behind by a crash: restore or discard?
  };
  Kind kind = Kind::none;
  std::filesystem::path about; ///< overwrite: what is to be written; restore: what was being edited.
};

enum class FileAnswer { save, discard, cancel, overwrite, otherName, restore };

/// Whom the file work acts for: what is open, and who shows what becomes of it.
class FileUser {
public:
  virtual ~FileUser() = default;
  [[nodiscard]] virtual OpenDocument& open() = 0;
  [[nodiscard]] virtual SavedForm form() const { return {}; } ///< How stretches are to be told in files.
  virtual void tell(Tone tone, const std::string& text) = 0;
  virtual void closing() = 0; ///< Called before what is open goes.
  virtual void opened() = 0;  ///< Another document is open.
  virtual void saved(const std::filesystem::path& path) = 0;
  virtual void quit() = 0; ///< Nothing keeps the program from ending.
};

/// Opening, saving and keeping aside the one file that is edited: a machine of states, one for each question,
/// with the opening of another file beside. It shows nothing: whoever has a window asks the question and
/// hands in the answer.
class FileWork {
public:
  using Paths = std::vector<std::filesystem::path>;
  /// Reads beside the caller; tells how much is done, 0..1.
  using Loader = std::function<Result<Opened>(const Paths&, const skinning::Progress&)>;

  explicit FileWork(Loader loader = openAny) : loader_(std::move(loader)) {}

  // Events.
  /// Opens a character or a mesh sequence (a path, or a base mesh and its cache); asks first when work would
  /// be lost.
  void openFile(FileUser& user, const Paths& paths);
  /// Saves a character where it was saved before, else asks for a name: the source is never overwritten by
  /// the first save.
  void save(FileUser& user);
  void saveAs(FileUser& user, const std::filesystem::path& path);
  /// Saves under the next free number: "punch-002.glb".
  void saveIncremental(FileUser& user);
  void exportClean(FileUser& user, const std::filesystem::path& path);
  /// Ends the program; asks first when work would be lost.
  void quit(FileUser& user);
  /// An answer to the open question; one that it does not offer changes nothing.
  void answer(FileUser& user, FileAnswer answer);
  /// The program is in front again: tells when another one changed the file.
  void returned(FileUser& user);
  /// Offers the work that a crash left behind: on this file, or on any when it is empty.
  void offerAutosave(const std::filesystem::path& file);
  /// Now and then: takes up a file that was read, and keeps unsaved work aside. Seconds of a clock that only
  /// runs forward.
  void update(FileUser& user, double nowSeconds);
  /// Closes what is open and forgets the autosave.
  void close(FileUser& user);

  // State.
  [[nodiscard]] FileQuestion question() const;
  [[nodiscard]] bool isOpening() const { return opening_.has_value(); }
  [[nodiscard]] std::string openingName() const; ///< Name for people; empty while nothing is opened.
  [[nodiscard]] float openingShare() const;      ///< 0..1; < 0 unknown.
  [[nodiscard]] const std::filesystem::path& path() const {
    return path_;
  } ///< File as opened or saved last; empty: none is.
  /// Whether an autosave holds this very state, and where it is worked on.
  [[nodiscard]] bool isKeptAside(const Session& session) const;

private:
  /// Steps that go on once the unsaved work is settled.
  struct Nothing {};
  struct Quit {};
  struct OpenPaths {
    Paths paths;
  };
  struct ShowRead {}; ///< A file that was read while the document was edited on.
  using Next = std::variant<Nothing, Quit, OpenPaths, ShowRead>;

  // The states.
  struct Idle {};
  struct AskingUnsaved {
    Next next;
  };
  struct AskingName {
    Next next;
  };
  struct AskingOverwrite {
    std::filesystem::path path;
    Next next;
  };
  struct OfferingAutosave {
    Autosave autosave;
  };
  using State = std::variant<Idle, AskingUnsaved, AskingName, AskingOverwrite, OfferingAutosave>;

  struct Opening {
    Paths paths;
    std::optional<std::filesystem::path> restoreFrom; ///< Autosave to take up then.
    std::optional<Document> given;                    ///< Unsaved work that the user gave up for it,
    std::optional<SequenceDocument> givenSequence;    ///< that of a sequence,
    UnkeyedPose givenPose;                            ///< and what was posed without a key.
    std::optional<FileStamp> stamp;                   ///< Stamp of the file, before it is read.
    std::shared_ptr<std::atomic<float>> share;
    std::future<Result<Opened>> work;
    std::optional<Opened> read; ///< Waits until it may be shown.
  };
  struct KeptAside {
    std::filesystem::path file;
    Document document;
    WorkPlace place;
  };

  void start(FileUser& user, const Paths& paths, std::optional<std::filesystem::path> restoreFrom);
  void takeRead(FileUser& user);
  void give(FileUser& user);
  [[nodiscard]] bool isGiven(const OpenDocument& open) const;
  void show(FileUser& user);
  void saveThen(FileUser& user, Next next);
  void write(FileUser& user, const std::filesystem::path& path, Next next);
  void goOn(FileUser& user, const Next& next);
  void restore(FileUser& user, const std::filesystem::path& autosave);
  void answerUnsaved(FileUser& user, const AskingUnsaved& asked, FileAnswer answer);
  void answerOverwrite(FileUser& user, const AskingOverwrite& asked, FileAnswer answer);
  void answerOffer(FileUser& user, const OfferingAutosave& offered, FileAnswer answer);
  void cancel();
  void keepAside(FileUser& user, double nowSeconds);
  void forgetKeptAside();
  void stamp(const std::filesystem::path& path, const std::optional<FileStamp>& stamp);
  [[nodiscard]] bool changedByOthers(const std::filesystem::path& path) const;

  Loader loader_;
  State state_;
  std::optional<Opening> opening_;
  std::filesystem::path path_;
  std::filesystem::path stampedPath_;                ///< File whose stamp is kept.
  std::optional<FileStamp> stamp_;                   ///< Stamp of the file as last read or written.
  bool changeTold_ = false;                          ///< The user knows that the file changed.
  std::shared_ptr<const gltf::Source> openedSource_; ///< The source as the file has it.
  std::optional<KeptAside> keptAside_;               ///< As it was kept the last time that it could be.
  bool keepFailureTold_ = false;                     ///< The last try failed, and the user knows.
  double keptAsideSeconds_ = -1e9;
};

/// Whether a character has work that no file holds, or a sequence what was done since it was opened or
/// exported.
[[nodiscard]] bool hasUnsavedWork(const OpenDocument& open);

/// Whether anything is lost where what is open is closed: unsaved work, or a pose without a key, which no
/// file holds.
[[nodiscard]] bool wouldLoseWork(const OpenDocument& open);

/// The name to show, of a folder with a slash at its end too.
[[nodiscard]] std::string shownName(const std::filesystem::path& path);

/// "punch-002.glb" after "punch.glb" and "punch-001.glb": the first free number above the name's own.
[[nodiscard]] std::filesystem::path nextIncrement(const std::filesystem::path& path);

} // namespace stretch::app
