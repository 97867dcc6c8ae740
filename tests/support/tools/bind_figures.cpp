#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <cstdio>
#include "app/document.h"
#include "app/files/save.h"
#include "app/evaluate/evaluate.h"
#include "skinning/linear_blend_skinning.h"
#include "skinning/bind/bind_weights.h"
using namespace stretch;
int main(int argc, char** argv) {
  skinning::BindSettings settings;
  settings.cubesAlong = std::atoi(argv[1]); settings.blend = std::atof(argv[2]); settings.sections = std::atof(argv[3]);
  for (int f = 5; f < argc; ++f) {
    const Result<app::Document> document = app::openDocument(argv[f]);
    if (!document) { std::puts(document.error().line().c_str()); continue; }
    const Scene& scene = *document->scene;
    // joints of all skins, by node
    const NodeIndex hips = document->biped.hips;
    const auto counts = [&](int n) { if (!hips.exists() || std::getenv("ALLJ")) return true; for (NodeIndex k(n); k.exists(); k = scene.nodes[at(k)].parent) if (k == hips) return true; return false; };
    std::map<int, std::size_t> jointOf; std::vector<skinning::BindJoint> joints; std::vector<int> nodes;
    for (const Skin& s : scene.skins) for (std::size_t i = 0; i < s.joints.size(); ++i) if (counts(s.joints[i].value) && jointOf.try_emplace(s.joints[i].value, joints.size()).second) {
      joints.push_back({Vec3(glm::inverse(s.inverseBind[i])[3]), -1}); nodes.push_back(s.joints[i].value); }
    for (std::size_t j = 0; j < joints.size(); ++j) { NodeIndex p = scene.nodes[at(NodeIndex(nodes[j]))].parent; while (p.exists() && !jointOf.count(p.value)) p = scene.nodes[at(p)].parent; if (p.exists()) joints[j].parent = static_cast<int>(jointOf[p.value]); }
    std::map<int, Mat4> inverseOf;
    { std::vector<double> used(joints.size(), 0); for (const NodeIndex n : skinning::drawnMeshNodes(scene)) { const Node& node = scene.nodes[at(n)]; if (node.skin < 0) continue; for (const Primitive& p : scene.meshes[(size_t)node.mesh].primitives) for (auto& inf : p.influences) for (size_t k = 0; k < 8; ++k) { auto f = jointOf.find(scene.skins[(size_t)node.skin].joints[inf.joints[k]].value); if (f != jointOf.end()) used[f->second] += inf.weights[k]; } }
      const auto worlds = rig::bindPoseWorlds(scene); std::map<int, Mat4> bindOf; for (const Skin& s : scene.skins) for (size_t i = 0; i < s.joints.size(); ++i) bindOf.emplace(s.joints[i].value, glm::inverse(s.inverseBind[i]));
      for (size_t j = 0; j < joints.size(); ++j) if (used[j] <= 0 && joints[j].parent >= 0) { Mat4 rest(1); NodeIndex k(nodes[j]); const int stop = nodes[(size_t)joints[j].parent]; for (; k.exists() && k.value != stop; k = scene.nodes[at(k)].parent) rest = (scene.nodes[at(k)].matrix ? *scene.nodes[at(k)].matrix : toMatrix(scene.nodes[at(k)].rest)) * rest; { const Mat4 whole = bindOf[stop] * rest; joints[j].place = Vec3(whole[3]); inverseOf[nodes[j]] = glm::inverse(whole); } } }
    std::vector<glm::vec3> positions; std::vector<Triangle> triangles;
    for (const NodeIndex n : skinning::drawnMeshNodes(scene)) { const Node& node = scene.nodes[at(n)]; if (node.skin < 0) continue;
      for (const Primitive& p : scene.meshes[(size_t)node.mesh].primitives) { const auto first = (std::uint32_t)positions.size(); positions.insert(positions.end(), p.positions.begin(), p.positions.end());
        for (size_t i = 0; i + 2 < p.indices.size(); i += 3) triangles.push_back({first + p.indices[i], first + p.indices[i+1], first + p.indices[i+2]}); } }
    const auto t0 = std::chrono::steady_clock::now();
    const auto bound = skinning::bindWeights(positions, triangles, joints, settings);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
    if (!bound) { std::puts(bound.error().line().c_str()); continue; }
    { std::map<std::string,int> firsts; for (size_t v = 0; v < bound->size(); ++v) if ((*bound)[v].weights[0] <= 0) firsts["zero"]++; std::map<size_t,int> c; for (auto& [k,v] : firsts) std::printf("%s %d\n", k.c_str(), v); std::printf("first joint %s\n", scene.nodes[(size_t)nodes[0]].name.c_str()); }
    if (std::getenv("WHO")) for (size_t j = 0; j < joints.size(); ++j) std::printf("joint %s %.3f %.3f %.3f\n", scene.nodes[(size_t)nodes[j]].name.c_str(), joints[j].place.x, joints[j].place.y, joints[j].place.z);
    Scene mine = scene; for (Skin& s : mine.skins) for (size_t i = 0; i < s.joints.size(); ++i) if (auto f = inverseOf.find(s.joints[i].value); f != inverseOf.end()) s.inverseBind[i] = f->second; std::size_t at0 = 0; std::vector<bool> done(scene.meshes.size(), false);
    for (const NodeIndex n : skinning::drawnMeshNodes(scene)) { const Node& node = scene.nodes[at(n)]; if (node.skin < 0) continue; const Skin& skin = scene.skins[(size_t)node.skin];
      std::map<int,int> slot; for (size_t i = 0; i < skin.joints.size(); ++i) slot.emplace(skin.joints[i].value, (int)i);
      for (Primitive& p : mine.meshes[(size_t)node.mesh].primitives) for (auto& inf : p.influences) { const auto& b = (*bound)[at0++]; inf = {};
        for (size_t k = 0; k < 8; ++k) { const auto s = slot.find(nodes[b.bones[k]]); inf.joints[k] = (std::uint16_t)(s == slot.end() ? 0 : s->second); inf.weights[k] = b.weights[k]; } } }
    double sum = 0; std::vector<float> all; double worstFrame=0; std::vector<double> perVertex; double height = document->biped.height; 
    for (std::size_t c = 0; c < document->clips->size(); ++c) { const Clip& clip = (*document->clips)[c]; const int frames = std::min(20, std::max(2, (int)((clip.endSeconds-clip.startSeconds)*10)));
      for (int k = 0; k < frames; ++k) { const FrameState s = app::evaluateOriginal(*document, (int)c, clip.startSeconds + (clip.endSeconds-clip.startSeconds)*k/(frames-1));
        const auto a = skinning::skinnedPositions(scene, s); const auto b = skinning::skinnedPositions(mine, s); double fr=0;
        for (size_t i = 0; i < a.size(); ++i) { const double d = glm::distance(a[i], b[i]) / height; sum += d*d; fr+=d*d; if (perVertex.size() < a.size()) perVertex.resize(a.size()); perVertex[i] += d*d; all.push_back((float)d); } worstFrame=std::max(worstFrame,std::sqrt(fr/(double)a.size())); } }
    if (std::getenv("DIAG")) { std::map<std::pair<std::string,std::string>, std::pair<double,int>> pairs; size_t v = 0, w = 0;
      for (const NodeIndex n : skinning::drawnMeshNodes(scene)) { const Node& node = scene.nodes[at(n)]; for (const Primitive& p : scene.meshes[(size_t)node.mesh].primitives) for (size_t i = 0; i < p.positions.size(); ++i, ++v) { if (node.skin < 0) continue; const auto& inf = p.influences[i]; size_t best = 0; for (size_t k = 1; k < 8; ++k) if (inf.weights[k] > inf.weights[best]) best = k; const auto& b = (*bound)[w++]; 
        if (std::getenv("WHO") && scene.nodes[(size_t)nodes[b.bones[0]]].name == std::getenv("WHO")) std::printf("v %zu at %.3f %.3f %.3f w %.2f artist %s\n", w-1, p.positions[i].x, p.positions[i].y, p.positions[i].z, b.weights[0], scene.nodes[at(scene.skins[(size_t)node.skin].joints[inf.joints[best]])].name.c_str());
        auto& e = pairs[{scene.nodes[at(scene.skins[(size_t)node.skin].joints[inf.joints[best]])].name, scene.nodes[(size_t)nodes[b.bones[0]]].name}]; e.first += perVertex[v]; ++e.second; } }
      double whole=0; for (auto& [k,e] : pairs) whole += e.first; std::vector<std::pair<double,std::string>> lines; for (auto& [k,e] : pairs) lines.push_back({e.first/whole, k.first + " -> " + k.second + "  n=" + std::to_string(e.second)}); std::sort(lines.rbegin(), lines.rend()); for (size_t i = 0; i < 14 && i < lines.size(); ++i) std::printf("   %5.1f%% %s\n", 100*lines[i].first, lines[i].second.c_str()); }
    const size_t q = all.size()*99/100; std::nth_element(all.begin(), all.begin()+(long)q, all.end());
    std::string name = argv[f]; name = name.substr(name.rfind('/')+1).substr(0,18);
    std::printf("%-18s verts %6zu joints %3zu  rms %.2f%%  p99 %.2f%%  worst frame %.2f%%  %.1f s\n", name.c_str(), positions.size(), joints.size(), 100*std::sqrt(sum/(double)all.size()), 100*(double)all[q], 100*worstFrame, seconds);
  }
}
