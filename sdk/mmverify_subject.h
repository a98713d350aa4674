/* The interface between mmverify and an implementation under test.
 *
 * Build a shared library that exports one function, mmverify_subject_v1, and hand it over:
 *
 *     cc -O2 -shared -fPIC -o mine.so mine.c && mmverify prove --subject ./mine.so
 *
 * Every entry point is optional: leave a pointer null and the laws that need it say not_applicable. The
 * library is loaded into a process of its own; a crash, a hang, a write outside the buffers, exit() or an
 * exception ends that process alone and is reported with the case that did it.
 *
 * Contract of every entry point:
 *   - count is 1 or more; arrays hold count elements (corners: 6 times count). Inputs are read-only.
 *   - the answer for an element depends on that element and the level alone: not on its place in the batch,
 * the batch's size, earlier calls or the thread. Anything else is reported as non-deterministic.
 *   - calls come from several threads of one process at once, unless flags has MMVERIFY_SINGLE_THREADED.
 *   - the rounding and flush-to-zero modes are those of a fresh process, and are left as they were found.
 *   - nothing is thrown across this border.
 */
#ifndef MMVERIFY_SUBJECT_H
#define MMVERIFY_SUBJECT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Grows with every change that an older subject would not survive. New entry points come at the end: `size`
 * tells. */
#define MMVERIFY_SUBJECT_ABI 1u

/* flags */
#define MMVERIFY_SINGLE_THREADED 1u

typedef struct mmverify_subject {
  uint32_t abi;       /* MMVERIFY_SUBJECT_ABI */
  uint32_t size;      /* sizeof(mmverify_subject) */
  const char* name;   /* for messages; may be null */
  uint32_t max_level; /* the highest level it is defined at, up to 16 */
  uint32_t flags;

  /* Index of the micro-triangle that holds (u[k], v[k]), as VK_EXT_opacity_micromap has it: u belongs to the
   * second vertex, v to the third. u, v >= 0; u+v <= 1, or an ulp over, as hits on the hypotenuse come. */
  void (*index_f32)(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count);
  void (*index_f64)(uint32_t level, const double* u, const double* v, uint32_t* index, size_t count);

  /* Corners of the micro-triangle that carries index[k] < 4^level: i0 j0 i1 j1 i2 j2, in units of 1/2^level
   * along u and v. The order of the three matters to the law index.corners alone: that of the children 0, 2
   * and 3 that touch them. */
  void (*corners)(uint32_t level, const uint32_t* index, uint32_t* corners, size_t count);

  /* The same two in row order (Gruen et al.; Color and Attribute Micromaps, figure 4). */
  void (*row_index_f32)(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count);
  void (*row_corners)(uint32_t level, const uint32_t* index, uint32_t* corners, size_t count);

  /* Codecs and bakers will have their entry points after these. */
} mmverify_subject_t;

/* The one exported symbol. The result must stay valid for the life of the process; null is an error. */
const mmverify_subject_t* mmverify_subject_v1(void);

#ifdef __cplusplus
}
#endif

#endif
