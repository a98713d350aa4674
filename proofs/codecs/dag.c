/* Laws of codes of scenes.  SIZE: bytes of a hostile code. */
#include "proofs/codecs/law.h"

enum { ROOM = 64 };

/* dag.malformed: any SIZE bytes are refused, or are a scene, which is the same at each call; nothing is written without
 * room, or behind the scene. */
void malformed(void) {
  uint8_t code[SIZE + (SIZE == 0)], scene[ROOM], again[ROOM];
  any_bytes(code, SIZE);
  const uint8_t before = (uint8_t)any(8);
  for (size_t k = 0; k < ROOM; ++k) scene[k] = again[k] = before;
  const size_t size = codec()->dag_decode(FORMAT, code + (SIZE == 0), SIZE, scene, ROOM);
  check_is(codec()->dag_decode(FORMAT, code + (SIZE == 0), SIZE, again, 0), size);
  for (size_t k = 0; k < ROOM; ++k) check_is(again[k], before);
  if (size == 0) return;
  check_is(codec()->dag_decode(FORMAT, code + (SIZE == 0), SIZE, again, ROOM), size);
  for (size_t k = 0; k < ROOM; ++k) check(scene[k] == again[k] && (k < size || scene[k] == before));
}
