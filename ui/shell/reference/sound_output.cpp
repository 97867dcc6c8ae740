#include "ui/shell/reference/sound_output.h"

#include <cstdint>

#include <AL/al.h>
#include <AL/alc.h>

namespace stretch::ui {

// One source with one buffer, which holds the whole sound.
struct SoundOutput::Device {
  ALCdevice* device = nullptr;
  ALCcontext* context = nullptr;
  ALuint source = 0;
  ALuint buffer = 0;
  std::shared_ptr<const app::Sound> held; ///< Sound in the buffer.

  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device() {
    if (context != nullptr) {
      alDeleteSources(1, &source);
      alDeleteBuffers(1, &buffer);
      alcMakeContextCurrent(nullptr);
      alcDestroyContext(context);
    }
    if (device != nullptr) {
      alcCloseDevice(device);
    }
  }

  [[nodiscard]] bool open() {
    device = alcOpenDevice(nullptr);
    context = device == nullptr ? nullptr : alcCreateContext(device, nullptr);
    if (context == nullptr || alcMakeContextCurrent(context) == ALC_FALSE) {
      return false;
    }
    alGenSources(1, &source);
    alGenBuffers(1, &buffer);
    return alGetError() == AL_NO_ERROR;
  }

  /// False where the system has no room for the sound.
  [[nodiscard]] bool hold(const std::shared_ptr<const app::Sound>& sound) {
    if (held == sound) {
      return true;
    }
    alSourceStop(source);
    alSourcei(source, AL_BUFFER, 0);
    held = nullptr;
    alGetError();
    alBufferData(buffer, AL_FORMAT_STEREO16, sound->samples.data(),
                 static_cast<ALsizei>(sound->samples.size() * sizeof(std::int16_t)), sound->samplesPerSecond);
    alSourcei(source, AL_BUFFER, static_cast<ALint>(buffer));
    held = alGetError() == AL_NO_ERROR ? sound : nullptr;
    return held != nullptr;
  }
};

SoundOutput::SoundOutput() = default;
SoundOutput::SoundOutput(SoundOutput&&) noexcept = default;
SoundOutput& SoundOutput::operator=(SoundOutput&&) noexcept = default;
SoundOutput::~SoundOutput() = default;

Status SoundOutput::play(const std::shared_ptr<const app::Sound>& sound, double fromSeconds, double speed,
                         double volume) {
  if (device_ == nullptr) {
    auto opened = std::make_unique<Device>();
    if (!opened->open()) {
      return Error{"no sound can be played: the system has no device for it", "",
                   "the sound is still seen in the timeline"};
    }
    device_ = std::move(opened);
  }
  if (!device_->hold(sound)) {
    return Error{"the system has no room to play the sound", "", "give a shorter one"};
  }
  alSourceStop(device_->source);
  alSourcef(device_->source, AL_GAIN, static_cast<float>(volume));
  alSourcef(device_->source, AL_PITCH, static_cast<float>(speed));
  alSourcef(device_->source, AL_SEC_OFFSET, static_cast<float>(fromSeconds));
  alSourcePlay(device_->source);
  return Success{};
}

void SoundOutput::setVolume(double volume) {
  if (device_ != nullptr) {
    alSourcef(device_->source, AL_GAIN, static_cast<float>(volume));
  }
}

void SoundOutput::stop() {
  if (device_ != nullptr) {
    alSourceStop(device_->source);
  }
}

bool SoundOutput::isPlaying() const {
  ALint state = AL_STOPPED;
  if (device_ != nullptr) {
    alGetSourcei(device_->source, AL_SOURCE_STATE, &state);
  }
  return state == AL_PLAYING;
}

double SoundOutput::seconds() const {
  ALfloat seconds = 0.0F;
  if (isPlaying()) {
    alGetSourcef(device_->source, AL_SEC_OFFSET, &seconds);
  }
  return seconds;
}

} // namespace stretch::ui
