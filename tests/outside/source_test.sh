#!/usr/bin/env bash
# prove index.floats --source: functions that are wrong on a few pairs are refuted, by pairs on which the compiled function
# is wrong; what cannot be judged is named.
# usage: tests/outside/source_test.sh MMVERIFY ROOT [--every | --brief]    --every: proves the right one, too, which takes minutes;
#        --brief: of each kind of refutation one, in shaders of what is undefined two
set -euo pipefail

(($# >= 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
mmverify=$(readlink -f -- "$1") root=$(readlink -f -- "$2")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
wrong=$root/tests/subjects/wrong_source.c
failures=0
fail() { printf 'FAILED: %s\n' "$*"; failures=$((failures + 1)); }

# judged CODE PATTERN ARGS...: exit code, and a line of what is said.
judged() {
  local wanted=$1 pattern=$2 code=0
  shift 2
  "$mmverify" prove index.floats --details --quiet --flag="-I$root" "$@" >said 2>&1 || code=$?
  ((code == wanted)) || { cat said; fail "$*: exit code $code, not $wanted"; }
  grep -qE -- "$pattern" said || { cat said; fail "$*: nothing said like: $pattern"; }
}

judged 4 'no such file' --source missing.c
grep -q 'llvm-14-dev' said && { echo "SKIPPED: $(cat said)"; exit 77; }

# A header is read as C, and where that fails as C++.
printf '%s\n' '#include <cstdint>' 'inline std::uint32_t index_of(std::uint32_t, float, float) { return 0; }' >cpp.h
cp cpp.h cpp.hpp
printf 'static inline unsigned index_of(unsigned level, float u, float v) { int new = 0; return new; }\n' >c.h
for file in cpp.h cpp.hpp c.h; do judged 1 "^refuted .* subject $file:index_of expected 1 got 0" --source $file --function index_of --case 1@u=0x1p-2,v=0x1p-2; done

# What is undefined, whatever LLVM's passes would make of it.
undefined() {
  judged 1 "undefined: $1" --source "$2" --function "$3" --levels 1
  printf '%s: %s\n' "$3" "$(grep -o 'undefined: .* replay' said | head -1)"
}
undefined 'a sum, difference or product that does not fit, .*wrong_source.c:' "$wrong" overflows
undefined 'shl: a shift too far' "$wrong" shifted
undefined 'a value that was never set, .*wrong_source.c:' "$wrong" never_set
undefined "a read outside of a table's row" "$wrong" other_row
undefined 'fptoui: a float beyond the integers it becomes' "$wrong" cast
undefined 'a value that was never set, .*wrong_source.c:' "$wrong" of_a_loop
undefined 'a place that must not be reached, .*wrong_source.c:' "$wrong" without_end
undefined 'an assumption that does not hold, .*wrong_source.c:' "$wrong" assuming
# What was never set, and what passes would make of it.
unset=(less_itself of_no_bits of_all_bits two_less member_itself)
right=(by_value with_holes bit_fields of_union of_bytes set_late of_pointers unset_character of_pair of_array of_references)
[[ ${3-} != --brief ]] || unset=(less_itself of_no_bits) right=(by_value bit_fields of_union of_pointers of_array of_references)
for function in "${unset[@]}"; do undefined 'a value that was never set, .*wrong_source.c:' "$wrong" "$function"; done
undefined 'shl: a shift too far' "$wrong" far_of_no_bits
undefined 'an access outside of a variable, .*wrong_source.c:' "$wrong" beyond_an_array
judged 2 'wrong_source.c:[0-9]+: load: memory that is no constant table' --source "$wrong" --function through_null --levels 1
undefined 'a pointer or reference to fewer bytes, or at another place, than is said of it, .*array:' "${wrong}pp" captured
judged 2 'wrong_source.c:[0-9]+: a number taken for one of another type' --source "$wrong" --function by_pointer --levels 1
# Memory: what passes would drop, and what compilers may take for apart; --case alone, as it says so in a second.
memory=$root/tests/subjects/wrong_memory.c there=1@u=0x1.3c6ef2p-2,v=0.25
for function in written_by_one_more cleared_beyond copied_beyond; do
  judged 1 'undefined: an access outside of a variable, .*wrong_memory.c:' --source "$memory" --function $function --case $there
done
for function in next_member wrapped_around; do
  judged 1 "undefined: a read outside of a table's row, .*wrong_memory.c:" --source "$memory" --function $function --case $there
done
judged 1 'undefined: a value that its type does not have, .*wrong_memory.c:' --source "$memory" --function bool_of_two --case $there
judged 2 'wrong_memory.c:[0-9]+: a number taken for one of another type' --source "$memory" --function by_another_type --levels 0
judged 2 'wrong_memory.c:[0-9]+: a call whose restricted pointer' --source "$memory" --function restricted --levels 0
judged 2 'wrong_memory.c:[0-9]+: alloca: a pointer' --source "$memory" --function after_its_block --levels 0
judged 2 'wrong_memory.c:[0-9]+: load: a variable whose declaration is jumped past' --source "$memory" --function jumped_past --levels 0
judged 0 '^holds index.floats level 1' --source "$memory" --function by_the_rules --case $there
# Pointers that lead nowhere, whether or not anybody reads through them.
judged_there() { judged 1 "undefined: $1, .*$(basename "$2"):" --source "$2" --function "$3" --case $there; }
judged_there 'a pointer that leaves what it points into, or a null pointer that is moved' "$wrong" leaves_a_table
judged_there 'a pointer that leaves what it points into, or a null pointer that is moved' "$wrong" moved_null
judged_there "a read outside of a table's row, of a member or of the whole" "$wrong" of_a_table_and_no_bits
judged_there 'a pointer that was never set' "$wrong" copied_unset
for function in null_argument of_nothing; do
  source=$wrong
  [[ $function != of_nothing ]] || source=${wrong}pp
  judged_there 'a null pointer as an argument, a result or a reference that is said to be none' "$source" $function
done
judged_there 'a pointer or reference to fewer bytes, or at another place, than is said of it' "${wrong}pp" of_one_past
judged_there 'an access of a variable whose block has ended, or not begun' "${wrong}pp" of_one_gone
judged 2 'wrong_source.c:[0-9]+: own is thread_local' --source "$wrong" --function of_a_thread --levels 0
judged 2 '^n/a index.floats level 1 .*wrong_memory.c:[0-9]+: alloca: a pointer' --source "$memory" --function after_its_block --case $there
# A caller in C gets the sign.
judged 1 'expected [0-9]+ got 4294' --source "$wrong" --function of_16_bits --levels 8
judged 1 'expected [0-9]+ got 4294' --source "$wrong" --function of_8_bits --levels 4
# Parts that were never set and that nobody looks at are no fault.
for function in "${right[@]}"; do
  source=$root/tests/subjects/right_source.c
  [[ ! $function =~ ^of_(pair|array|references)$ ]] || source=${source}pp
  judged 0 '^holds index.floats level 3' --source "$source" --function "$function" --case 3@u=0.3,v=0.25
done
judged 2 'wrong_source.c:[0-9]+: call of llvm.is.constant' --source "$wrong" --function constant_level --levels 1
judged 2 "'wide' is i64 \(i32, float, float\); due is uint32_t.*: its result has 64 bits" --source "$wrong" --function wide --levels 1

refuted=(one_pair by_bits flushed over undefined by_product) undefined_in_shaders=(of_nan turned_clamp negative_rest field_beyond never_set)
[[ ${3-} != --brief ]] || refuted=(one_pair undefined) undefined_in_shaders=(field_beyond never_set)
for function in "${refuted[@]}"; do
  judged 1 "^refuted index.floats level 1 case u=.* expected [0-9]+ got [0-9]+" --source "$wrong" --function "$function" --levels 1
  # The line runs the compiled function again.
  again=$(sed -n 's/.*replay: mmverify //p' said | head -1)
  code=0
  eval "\"\$mmverify\" $again" >again 2>&1 || code=$?
  if [[ $function == undefined ]]; then
    grep -q 'undefined: lshr: a shift too far' said || { cat said; fail "undefined: the cause is not named"; }
    ((code == 1)) && grep -q 'undefined: lshr: a shift too far' again || { cat again; fail "undefined: its case does not show again"; }
  elif ((code != 1)) || ! grep -q '^refuted index.floats level 1' again; then
    cat said again
    fail "$function: its counterexample does not show again"
  fi
  printf '%s: %s\n' "$function" "$(grep -o 'case u=.*replay' said | head -1)"
done

judged 2 'wrong_source.c:[0-9]+: (br|switch): a loop that no constant ends' --source "$wrong" --function endless --levels 1
judged 2 'wrong_source.c:[0-9]+: load: memory is no constant' --source "$wrong" --function remembers --levels 1
judged 2 "no function is called 'index_off'; there are: .*index_of" --source "$wrong" --function index_off
printf 'unsigned index_of(unsigned level, float u, float v) { return level; }\n' >no_language
judged 2 'no_language: its name tells no language' --source no_language
# Both dialects on a pair where they differ, and functions that are of the other one.
published=$root/examples/subject_published/published.c differing=1@u=0x1p-26,v=0x1.fffffep-2
judged 0 '^holds index.floats level 1' --source "$published" --dialect published --case $differing
judged 1 'expected [0-9]+ got ([0-9]+) \(the published code gives \1 here, too\)' --source "$published" --case $differing
sed 's|return apart(b0)|if (u == 0x1.3c6ef2p-2f \&\& v == 0.25f) b0 ^= 1;\n  &|' "$published" >one_pair_off.c
judged 1 '^refuted index.floats level 1 case u=0x1.3c6ef2p-2,v=0x1p-2 ' --source one_pair_off.c --dialect published --levels 1
judged 1 . --source "$published" --levels 1 --journal one.journal
judged 4 'the journal of another run' --source "$published" --levels 1 --journal one.journal --dialect published
judged 1 'case .*: the published code gives [0-9]+ here, too; add --dialect published' --source "$published" --levels 1
# The topic stands for its one law of a source.
code=0
"$mmverify" prove index --quiet --source "$root/examples/subject/subject.c" --dialect published --levels 1 >said 2>&1 || code=$?
((code == 1)) && grep -q '^refuted    index.floats' said || { cat said; fail "prove index --source: exit code $code"; }
judged 1 '^refuted index.floats level 1 .*--dialect published --case' --source "$root/examples/subject/subject.c" --dialect published --levels 1
! grep -q 'here, too' said || fail 'the exact function is said to be the published code'
judged 1 '^refuted index.floats level 1' --source "$wrong" --function one_pair --levels 1
! grep -q 'here, too' said || fail 'a wrong function is said to be the published code'
judged 2 'levels 0..16' --source "$wrong" --function right --levels 1 --case 17@u=0,v=0
judged 2 'u \+ v <= 1 \+ 2\^-23' --source "$wrong" --function right --levels 1 --case 0@u=1,v=1
judged 2 "'no_index' is float \(float, float\); due is uint32_t \(uint32_t level, float u, float v\)" --source "$wrong" --function no_index
judged 2 'index.floats is proved of a function, and nothing else' index.nested --source "$wrong"
# Shaders, by their SPIR-V.
if command -v glslangValidator >/dev/null; then
  shader=$root/tests/subjects/wrong_source.glsl
  for function in one_pair plain_sum; do
    judged 1 "^refuted index.floats level 1 case .*u=.* expected [0-9]+ got [0-9]+" --source "$shader" --function "$function" --levels 1
    printf 'GLSL, %s: %s\n' "$function" "$(grep -o 'case .*u=.*replay' said | head -1)"
  done
  judged 1 "undefined: fptoui|expected 0 got" --source "$shader" --function far --levels 0
  for function in "${undefined_in_shaders[@]}"; do
    undefined '(a value that was never set|shl: a shift too far).*' "$shader" "$function"
    grep -qE '(never set|bits lost), .*wrong_source.glsl:' said || fail "$function: no place"
  done
  judged_there "a read outside of a table's row, of a member or of the whole" "$shader" of_no_bits
  judged 2 'wrong_source.glsl:[0-9]+: a specialization constant' --source "$shader" --function specialized --levels 0
  # HLSL shifts by the amount modulo the width, and GLSL does not.
  printf 'uint index(uint level, float u, float v) { uint x = asuint(u); return (x << (u > v ? 32 : 0)) ^ x; }\n' >shift.hlsl
  judged 0 '^holds' --source shift.hlsl --function index --case 0@u=0.5,v=0.25
  printf 'uint index(uint level, float u, float v) { uint x = floatBitsToUint(u); return (x << (u > v ? 32 : 0)) ^ x; }\n' >shift.glsl
  judged 1 'undefined: shl: a shift too far' --source shift.glsl --function index --case 0@u=0.5,v=0.25
  judged 2 'a pointer|memory that is no constant table' --source "$shader" --function set_late --levels 1
  judged 2 "'two_of_a_name' is two_of_a_name\(u1;f1;f1; and two_of_a_name\(f1;f1;u1;" --source "$shader" --function two_of_a_name --levels 1
  judged 2 'wrong_source.glsl:16: (OpFDiv|opcode 136)' --source "$shader" --function third --levels 1
  judged 2 'memory that is no constant table' --source "$shader" --function of_buffer --levels 1
  judged 2 'wrong_source.glsl:(18|19): RelaxedPrecision \(mediump\): a device may compute in 16 bits' --source "$shader" --function in_16_bits --levels 1
  judged 2 'wrong_source.glsl:20: (Round|instruction 1) of GLSL.std.450' --source "$shader" --function rounds --levels 1
  judged 2 'wrong_source.glsl:[0-9]+: br: a loop that no constant ends' --source "$shader" --function endless --levels 1
  judged 2 "no function is called 'index_off'; there are: .*one_pair" --source "$shader" --function index_off
  { cat "$root/examples/subject_published/index.hlsl"; echo 'uint index(uint level, float u, float v) { return micromapIndex(level, float2(u, v)); }'; } >published.hlsl
  judged 1 '^refuted index.floats level 1 case' --source published.hlsl --function index --levels 1
  printf 'uint index(uint level, float u, float v) { return uint(u) + level; }\n' >small.glsl
  printf '#version 450\n%s\nvoid main() {}\n' "$(cat small.glsl)" >small.comp
  glslangValidator -V --keep-uncalled -o small.spv small.comp >/dev/null
  judged 1 '^refuted index.floats level 0 case' --source small.spv --function index --levels 0
  if command -v spirv-opt >/dev/null; then
    { printf '#version 450\n#extension GL_GOOGLE_include_directive : require\n#include "shaders/index.glsl"\nvoid main() {}\n'
      grep '^bool one' "$shader"; sed -n '/^uint less_itself/,/^}/p' "$shader"; } >unset.comp
    glslangValidator -V --keep-uncalled "-I$root/subjects" -o unset.spv unset.comp >/dev/null
    spirv-opt --ssa-rewrite --simplify-instructions -o undef.spv unset.spv
    for module in unset undef; do judged 1 'undefined: a value that was never set' --source $module.spv --function less_itself --levels 1; done
  else
    echo 'OpUndef: left out, no spirv-opt'
  fi
  head -c 200 small.spv >cut.spv
  judged 2 'cut.spv: .*(spirv-val|no valid SPIR-V)' --source cut.spv --function index --levels 0
else
  echo 'shaders: left out, no glslangValidator'
fi
printf 'unsigned index_of(unsigned level, float u, float v) { return leve; }\n' >typo.c
judged 2 "typo.c:1:[0-9]+: error: use of undeclared identifier 'leve'" --source typo.c
MMVERIFY_CLANG=no-clang judged 4 '^mmverify: .*no-clang: there is no such compiler; install it \(Debian: clang\)' --source "$wrong" --function right
MMVERIFY_SOURCE_READER=$folder/none judged 4 'mmverify: .*none: there is no program of that name|llvm-14-dev' --source "$wrong" --function right

if [[ ${3-} == --every ]]; then
  judged 0 '^proved \(bit vectors\) index.floats .* level 0 ' --source "$wrong" --function right --levels 0
  judged 0 '^proved \(bit vectors\) index.floats .* level 0 ' --source "$root/examples/subject/subject.c" --levels 0
  judged 0 '^proved \(bit vectors\) index.floats .* level 1 ' --source "$published" --dialect published --levels 1
fi
((failures == 0)) || { echo "$failures failed"; exit 1; }
echo 'source_test: all refuted and named'
