// The sizes of a scene's maps in each form, as tables and a picture.
#pragma once

#include "bench/result.hpp"
#include "bench/scene/dag.hpp"

namespace mmverify::bench {

/// The tables of a scene's forms.  Domain: figures of at least one row.
Result scene_dag_tables(const SceneDagScene& figures, const SceneDagOptions& options);

/// A column each for two and for four states: bytes a map over ns a lookup, and below it over the level, a
/// line a form.
picture::Picture scene_dag_picture(const SceneDagScene& figures);

}  // namespace mmverify::bench
