#include "rig/rekey/span_fit.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace stretch::rig {

namespace {

Vec4 onHemisphereOf(const Vec4& from, const Vec4& to) {
  return glm::dot(from, to) < 0.0 ? -to : to;
}

// Weights of a cubic Hermite piece at u in [0, 1]: of its values and, for a piece of 1 second, its tangents.
struct HermiteWeights {
  double start = 1.0;
  double outTangent = 0.0;
  double end = 0.0;
  double inTangent = 0.0;
};

HermiteWeights hermiteAt(double u) {
  const double u2 = u * u;
  const double u3 = u2 * u;
  return {2 * u3 - 3 * u2 + 1, u3 - 2 * u2 + u, 3 * u2 - 2 * u3, u3 - u2};
}

struct Sample {
  double u = 0.0;
  Vec4 value{0.0};
};

// The exact motion inside the span; two samples determine the tangents.
std::vector<Sample> samplesOf(ExactMotion& exact, const ChangedChannel& channel, const ChannelSpan& span) {
  const double length = span.endSeconds - span.startSeconds;
  std::vector<double> times = checkTimes(exact.motion().framesPerSecond, span.startSeconds, span.endSeconds);
  if (times.size() < 2) {
    times = {span.startSeconds + length / 3.0, span.startSeconds + 2.0 * length / 3.0};
  }
  std::vector<Sample> samples;
  Vec4 before = span.start;
  for (const double time : times) {
    Vec4 value = channelValue(exact.at(time).pose, channel.node, channel.channel);
    value = channel.channel == Channel::rotation ? onHemisphereOf(before, value) : value;
    samples.push_back({(time - span.startSeconds) / length, value});
    before = value;
  }
  return samples;
}

void fitTangents(const std::vector<Sample>& samples, ChannelSpan& span) {
  const double length = span.endSeconds - span.startSeconds;
  double outOut = 0.0;
  double outIn = 0.0;
  double inIn = 0.0;
  Vec4 outMiss(0.0);
  Vec4 inMiss(0.0);
  for (const Sample& sample : samples) {
    const HermiteWeights w = hermiteAt(sample.u);
    const Vec4 miss = sample.value - w.start * span.start - w.end * span.end;
    const double out = length * w.outTangent;
    const double in = length * w.inTangent;
    outOut += out * out;
    outIn += out * in;
    inIn += in * in;
    outMiss += out * miss;
    inMiss += in * miss;
  }
  const double determinant = outOut * inIn - outIn * outIn;
  if (determinant > 0.0) {
    span.outTangent = (inIn * outMiss - outIn * inMiss) / determinant;
    span.inTangent = (outOut * inMiss - outIn * outMiss) / determinant;
  }
}

} // namespace

Vec4 ChannelSpan::at(Channel channel, double timeSeconds) const {
  const double length = endSeconds - startSeconds;
  const double u = (timeSeconds - startSeconds) / length;
  if (isCubic) {
    const HermiteWeights w = hermiteAt(u);
    return w.start * start + w.end * end + length * (w.outTangent * outTangent + w.inTangent * inTangent);
  }
  if (channel == Channel::rotation) {
    const Quat turn =
        glm::slerp(Quat(start.w, start.x, start.y, start.z), Quat(end.w, end.x, end.y, end.z), u);
    return {turn.x, turn.y, turn.z, turn.w};
  }
  return start + (end - start) * u;
}

ChannelSpan fitSpan(ExactMotion& exact, const ChangedChannel& channel, double startSeconds,
                    double endSeconds) {
  ChannelSpan span;
  span.startSeconds = startSeconds;
  span.endSeconds = endSeconds;
  span.start = channelValue(exact.at(startSeconds).pose, channel.node, channel.channel);
  span.end = channelValue(exact.at(endSeconds).pose, channel.node, channel.channel);
  span.isCubic = channel.isCubic;
  const bool turns = channel.channel == Channel::rotation;
  if (span.isCubic) {
    const std::vector<Sample> samples = samplesOf(exact, channel, span);
    span.end = turns ? onHemisphereOf(samples.back().value, span.end) : span.end;
    fitTangents(samples, span);
  } else if (turns) {
    span.end = onHemisphereOf(span.start, span.end);
  }
  return span;
}

std::vector<double> checkTimes(double framesPerSecond, double startSeconds, double endSeconds) {
  std::vector<double> times;
  const double step = 0.5 / framesPerSecond;
  for (double i = std::ceil(startSeconds / step); i * step < endSeconds; i += 1.0) {
    const double time = asKeyTime(i * step);
    if (time > startSeconds + sameKey && time < endSeconds - sameKey) {
      times.push_back(time);
    }
  }
  return times;
}

} // namespace stretch::rig
