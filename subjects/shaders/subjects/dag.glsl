// Lookups in the container of a scene's graph, which mmverify encodes.
#define MM_DAG_WORD(k) mmverify_word(k)
#include "shaders/dag.glsl"
#include "shaders/index.glsl"

uint dag_lookup(uint format, uint map, uint index) { return mm_dag_lookup(mm_dag_open(), map, index); }

uint dag_lookup_at(uint format, uint map, float u, float v) {
  return dag_lookup(format, map, mm_index_exact(mm_dag_level(map), u, v));
}
