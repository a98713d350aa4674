// A file whose micromaps are repaired: rules, links, maps.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "proofs/scene/cause/cause.hpp"
#include "proofs/scene/repair/relinks.hpp"
#include "scene/edit/edited_file.hpp"
#include "scene/edit/rules.hpp"

namespace mmverify::proofs::scene {

/// A triangle of the file, and what was done, or is to do.
struct RepairedTriangle {
  std::size_t primitive = 0;  ///< number in Scene::primitives
  std::size_t triangle = 0;
  std::string did;  ///< empty: it is left
};

/// A primitive whose link was changed as a whole.
struct RelinkedPrimitive {
  std::size_t primitive = 0;  ///< number in Scene::primitives
  std::string did;
};

/// All that was found and done.
struct RepairReport {
  std::vector<mmverify::scene::RuleRepair> rules;
  std::vector<mmverify::scene::FileViolation> broken;  ///< rules without a repair; then no map was judged
  std::vector<RelinkedPrimitive> primitives;
  std::vector<RepairedTriangle> triangles, left;
  std::map<std::size_t, std::size_t> judged;  ///< triangles with maps by primitive
  std::vector<mmverify::scene::NotJudged> not_judged;
  std::string cause;  ///< the one of the maps that are left, where there is one

  bool is_right() const { return rules.empty() && primitives.empty() && triangles.empty() && is_whole(); }
  bool is_whole() const { return broken.empty() && left.empty(); }
};

struct RepairRequest {
  bool bake = false;                        ///< bake the maps that nothing in the file puts right
  bool two_state = false;                   ///< the maps were forced to 2-state
  float margin = 0;                         ///< by which they were baked, in texels
  std::uint64_t samples = 60000, seed = 1;  ///< of broken_law()
  bool show_progress = false;
};

class FileRepair {
 public:
  /// Errors: BadScene.
  FileRepair(const std::string& file, const RepairRequest& request) : request_(request), file_(file) {}

  /// Repairs what it can.  Errors: BadScene; exceptions of baking; Interrupted.
  void run();

  const RepairReport& report() const { return report_; }
  const mmverify::scene::Scene& scene() const { return scene_; }
  mmverify::scene::EditedFile& file() { return file_; }

  /// The rule, or the law of baking, that the file breaks as it is written; empty where it keeps all of them, and each map
  /// is that of the exact baker.
  /// Domain: after run(), of which nothing is left.  Errors: as of run().
  std::string broken_law(const mmverify::scene::WrittenFile& written);

 private:
  mmverify::scene::Document document() const { return file_.reopened(file_.written()); }
  template <class Search>
  auto searched(const Search& search) const;
  void apply(const Relink& relink, const nlohmann::json& before);
  void relink();
  void unlink_unbakeable();
  std::set<std::size_t> planned(const std::vector<mmverify::scene::TriangleOfFile>& triangles) const;
  void refresh_records();
  void repair_maps(const std::vector<mmverify::scene::TriangleOfFile>& unlinked);

  const RepairRequest request_;
  mmverify::scene::EditedFile file_;
  mmverify::scene::Scene scene_;
  mmverify::scene::StoredMaps maps_;
  RepairReport report_;
};

}  // namespace mmverify::proofs::scene
