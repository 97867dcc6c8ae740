#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// Called now and then with the share of the work that is done (0..1). May be empty.
using Progress = std::function<void(double)>;

/// A folder of numbered .obj or .ply frames, in the order of the numbers in their names, or the series of one
/// of them (skinning/sequence/frame_names.h). Every frame must have the vertices and the triangles, or the
/// polygons, of the first. Numbers that are missing between others are told.
[[nodiscard]] Result<MeshSequence> readFrames(const std::filesystem::path& named,
                                              const Progress& progress = {});

/// A base mesh (OBJ, PLY or glTF) with a point cache of its vertices, in the order of its file: of an OBJ the
/// `v` lines, of a glTF the vertices of all meshes that it shows. PC2 (little endian; "POINTCACHE2\0",
/// version 1, points, start frame, frames between samples, samples) or MDD (big endian; samples, points, the
/// time of each sample in seconds); then x, y, z of every point, sample after sample. The times of an MDD
/// give the frame rate where `framesPerSecond` is 0; another rate than theirs, and a PC2 of some frames alone
/// without one, is told.
[[nodiscard]] Result<MeshSequence> readPointCache(const std::filesystem::path& base,
                                                  const std::filesystem::path& cache,
                                                  const Progress& progress = {},
                                                  double framesPerSecond = 0.0);

/// A folder that the particle simulation Sibernetic logged: `position_buffer.txt` (bounds and particle
/// counts, then x, y, z, type of every particle, frame after frame) and `membranes_buffer.txt` (a count, then
/// triples of particles, wound at random: they are oriented). Particles that no membrane uses are left out.
[[nodiscard]] Result<MeshSequence> readSibernetic(const std::filesystem::path& folder,
                                                  const Progress& progress = {});

/// An animated glTF as it is seen, frame by frame: every mesh of the scene with its morph targets, its skin
/// or its node, in world space, one vertex list after the other. `clip` is the name or "#index" of a clip;
/// empty takes the first one. Frames are those of `framesPerSecond`; 0: of the clip's own rate. An error when
/// the file has no clip or no mesh.
[[nodiscard]] Result<MeshSequence> readAnimatedGltf(const std::filesystem::path& path,
                                                    const std::string& clip = {},
                                                    const Progress& progress = {},
                                                    double framesPerSecond = 0.0);

/// Joins vertices that lie at one place in every frame, as files that split vertices along seams have them.
/// Returns the number of vertices that went.
std::size_t joinDuplicates(MeshSequence& sequence);

/// Files split vertices along seams: where the numbers of vertices differ, those that lie at one place in
/// every frame are joined in both, if that makes them agree.
void joinUntilAlike(MeshSequence& a, MeshSequence& b);

/// Returns what a user names, as readSequence takes it: a cache alone stands for itself and the mesh beside
/// it that has as many vertices, one of several numbered meshes for its folder where that holds nothing else,
/// a cache and its mesh may come in any order. Everything else stays as it is.
[[nodiscard]] std::vector<std::filesystem::path>
sequencePaths(const std::vector<std::filesystem::path>& named);

/// Reads what the words of a command line name: a folder of frames, a Sibernetic folder, a base mesh with a
/// cache, or a glTF with a morph-target clip; see sequencePaths. The warnings of the result tell what is odd
/// about the topology, and of several clips which one was taken. `clip`: of a glTF, see readAnimatedGltf.
/// `framesPerSecond`: the rate of the frames, 0 the source's; a glTF is sampled at it.
[[nodiscard]] Result<MeshSequence> readSequence(const std::vector<std::filesystem::path>& named,
                                                const Progress& progress = {}, const std::string& clip = {},
                                                double framesPerSecond = 0.0);

} // namespace stretch::skinning
