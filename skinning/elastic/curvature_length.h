#pragma once

#include <string>
#include <vector>

namespace stretch::skinning {

/// One frame of a body: total curvature of its centre line (radians) and its length.
struct CurvatureLength {
  double curvatureRadians = 0.0;
  double length = 0.0;
};

/// Straight line through the frames, as the paper fits it: length = slope * curvature + intercept.
struct LineFit {
  double slope = 0.0;
  double intercept = 0.0; ///< Length at curvature 0; the mean length when there is no slope to fit.
  double rSquared = 0.0;  ///< Share of the variance that the line explains; 0 when the lengths do not vary.
};

[[nodiscard]] LineFit fitLine(const std::vector<CurvatureLength>& frames);

/// Non-increasing curve through the frames: knots are the means of blocks of frames (pool adjacent violators,
/// least squares among all curves along which length never grows with curvature), joined by straight lines.
/// Copes with a length that saturates.
struct MonotoneFit {
  std::vector<double> curvatures; ///< Ascending, strictly.
  std::vector<double> lengths; ///< Descending; between the knots the curve is straight, beyond them constant.
  double rSquared = 0.0;

  [[nodiscard]] double at(double curvatureRadians) const;
};

[[nodiscard]] MonotoneFit fitMonotone(const std::vector<CurvatureLength>& frames);

/// `automatic` asks for the line, or for the monotone curve where that explains clearly more of many frames;
/// it is never what was taken.
enum class LengthModel { automatic, line, monotone, measuredMean };

/// Length as a function of curvature (Psi of the paper), with what is needed to judge it.
struct LengthFunction {
  LengthModel model = LengthModel::line; ///< Model by which `at` answers.
  LineFit line;
  MonotoneFit monotone;
  double meanLength = 0.0;
  std::size_t frameCount = 0;
  std::string remark; ///< Why the mean stands in for a line; empty otherwise.

  [[nodiscard]] double at(double curvatureRadians) const;
};

inline constexpr double leastRSquared = 0.3;
inline constexpr std::size_t fewestFrames = 4;

/// Fits both curves. With fewer than `fewestFrames` frames, or when the wanted curve explains less than
/// `leastRSquared` of the variance, the measured mean is used instead and the remark says so.
[[nodiscard]] LengthFunction fitLength(const std::vector<CurvatureLength>& frames,
                                       LengthModel wanted = LengthModel::automatic);

} // namespace stretch::skinning
