// Lookups in the graph of a scene's maps, which mmverify encodes.
#define MM_DAG_WORD(k) mmverify_word(k)
#include "shaders/dag.glsl"

uint dag_lookup(uint format, uint map, uint index) { return mm_dag_lookup(format, map, index); }
