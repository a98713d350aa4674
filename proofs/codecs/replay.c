/* Runs a harness on choices: those of one case, or, if they have few bits, all of them in turn.
 *
 *   replay NUMBER...     each choice in turn, in decimal; further ones are 0
 *   replay --all BITS    all choices, if their bits together are at most BITS: prints the number of cases
 *
 * Exit code 0: every check holds (or an assumption does not). 1: a check fails; standard error has the harness's line,
 * and in lines of their own "expected X", "got Y", and the name of what was compared, or the condition that is false.
 * 3: the harness has no room. 5: more than BITS bits. */
#include <inttypes.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "proofs/codecs/law.h"

void FUNCTION(void);

enum { MOST_CHOICES = 1 << 16 };
static uint64_t numbers[MOST_CHOICES];
static uint32_t widths[MOST_CHOICES];
static size_t given, used;
static jmp_buf end_of_case;

uint64_t any(uint32_t bits) {
  if (used == MOST_CHOICES) {
    fprintf(stderr, "more than %d choices\n", MOST_CHOICES);
    exit(5);
  }
  widths[used] = bits;
  return used < given ? numbers[used++] & (~(uint64_t)0 >> (64 - bits)) : (numbers[used++] = 0);
}
uint64_t any_state(uint32_t format) { return any(format); }

void assume(int holds) {
  if (!holds) longjmp(end_of_case, 1);
}

static void say_choices(void) {
  for (size_t k = 0; k < used; ++k) printf("choice %" PRIu32 " %" PRIu64 "\n", widths[k], numbers[k]);
  fflush(stdout);
}

static void end_with(const char* what) {
  fprintf(stderr, "name %s\n", what);
  say_choices();
  exit(1);
}

void mmverify_check_fails(int line, const char* condition) {
  fprintf(stderr, "line %d\n", line);
  end_with(condition);
}

void mmverify_check_differs(int line, const char* name, uint64_t got, uint64_t expected) {
  fprintf(stderr, "line %d\nexpected %" PRIu64 "\ngot %" PRIu64 "\n", line, expected, got);
  end_with(name);
}

void mmverify_check_bytes(int line, const char* name, const uint8_t* got, const uint8_t* expected,
                          size_t count) {
  for (size_t k = 0; k < count; ++k)
    if (got[k] != expected[k]) {
      fprintf(stderr, "line %d\nexpected 0x%02x in byte %zu\ngot 0x%02x\n", line, expected[k], k, got[k]);
      end_with(name);
    }
}
void mmverify_no_room(int line) {
  fprintf(stderr, "line %d\n", line);
  exit(3);
}

/* The next choices, as an odometer's: those that this case has used have the last one's place move first. */
static int next_case(void) {
  given = used;
  while (given > 0) {
    if (++numbers[given - 1] <= ~(uint64_t)0 >> (64 - widths[given - 1])) return 1;
    --given;
  }
  return 0;
}

static uint32_t bits_used(void) {
  uint32_t bits = 0;
  for (size_t k = 0; k < used; ++k) bits += widths[k];
  return bits;
}

int main(int count, char** arguments) {
  const int all = count == 3 && strcmp(arguments[1], "--all") == 0;
  for (int k = 1; !all && k < count && given < MOST_CHOICES; ++k)
    numbers[given++] = strtoull(arguments[k], NULL, 10);
  volatile uint64_t cases = 0;
  do {
    used = 0;
    if (setjmp(end_of_case) == 0) FUNCTION();
    ++cases;
    if (all && bits_used() > strtoul(arguments[2], NULL, 10)) return 5;
  } while (all && next_case());
  printf("%" PRIu64 " cases\n", cases);
  return 0;
}
