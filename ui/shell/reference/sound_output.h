#pragma once

#include <memory>

#include "app/reference/sound.h"

namespace stretch::ui {

/// Plays a sound on the system's device, which is opened when the first one is to be heard.
class SoundOutput {
public:
  SoundOutput();
  SoundOutput(SoundOutput&&) noexcept;
  SoundOutput& operator=(SoundOutput&&) noexcept;
  ~SoundOutput();

  /// Plays from a time on, what was played before stops. `speed`: multiple of the sound's own, above 0.
  /// `volume`: 0..1. Error: no device that plays.
  [[nodiscard]] Status play(const std::shared_ptr<const app::Sound>& sound, double fromSeconds, double speed,
                            double volume);
  void setVolume(double volume);
  void stop();
  [[nodiscard]] bool isPlaying() const;
  /// The time that is heard; 0 while nothing plays.
  [[nodiscard]] double seconds() const;

private:
  struct Device;
  std::unique_ptr<Device> device_;
};

} // namespace stretch::ui
