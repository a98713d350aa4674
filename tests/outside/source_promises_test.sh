#!/usr/bin/env bash
# prove index.floats --source: what a file says beside its operations. Names that compiled code calls, code that compilers
# put in, definitions that others replace, attributes and decorations that lie: each is named, or refuted, at a pair at which
# it is wrong; a right file of the same kind holds.
# usage: tests/outside/source_promises_test.sh MMVERIFY
set -euo pipefail

(($# == 1)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
mmverify=$(readlink -f -- "$1")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
failures=0
fail() { printf 'FAILED: %s\n' "$*"; failures=$((failures + 1)); }

# judged CODE PATTERN FILE FUNCTION ARGS...: exit code at the one pair, and a line of what is said.
judged() {
  local wanted=$1 pattern=$2 file=$3 function=$4 code=0
  shift 4
  "$mmverify" prove index.floats --source "$file" --function "$function" --threads 1 \
    --case 0@u=0x1.333334p-2,v=0x1.0002ap-2 "$@" >said 2>&1 || code=$?
  ((code == wanted)) || { cat said; fail "$file $function $*: exit code $code, not $wanted"; }
  grep -qE -- "$pattern" said || { cat said; fail "$file $function $*: nothing said like: $pattern"; }
}
holds() { judged 0 '^holds' "$@"; }
refused() { judged 2 "^n/a index.floats level 0 .*$1" "${@:2}"; }

printf 'unsigned index_of(unsigned level, float u, float v) { return 0; }\n' >plain.c
judged 0 '^holds|llvm-14-dev' plain.c index_of || true
grep -q 'llvm-14-dev' said && { echo "SKIPPED: $(cat said)"; exit 77; }

# A file's own functions under names that compiled code calls.
begin='#include <stddef.h>
#define THERE (u == 0.3f && v == 0.25001f)
#define INDEX unsigned index_of(unsigned level, float u, float v)'
c() { printf '%s\n%s\n' "$begin" "$2" >"$1.c"; }
copies='(void *to, const void *from, size_t n) { for (size_t k = 0; k < n; ++k) ((char *)to)[k] = ((const char *)from)[k]; return to; }
struct Big { char b[400]; };
INDEX { struct Big s = {{0}}, t; s.b[0] = THERE; t = s; return t.b[1]; }'
c own_memcpy "static __attribute__((used, noinline)) void *memcpy$copies"
c own_memset "__attribute__((weak)) void *memset$copies"
c own_bcmp "int bcmp(const void *a, const void *b, size_t n) { return 7; } INDEX { return 0; }"
c own_floorf 'static __attribute__((used)) float floorf(float x) { return x == 0.3f; } INDEX { return (unsigned)__builtin_floorf(u); }'
c own_ceilf '__attribute__((visibility("hidden"))) float ceilf(float x) { return 1; } INDEX { return (unsigned)__builtin_ceilf(u) - 1; }'
c assembly 'asm(".text\n.globl floorf\nfloorf: ret\n"); INDEX { return (unsigned)__builtin_floorf(u); }'
refused 'own_memcpy.c:4: the file defines its own memcpy, which compiled code calls' own_memcpy.c index_of
refused 'own_memset.c:4: the file defines its own memset' own_memset.c index_of
refused 'own_bcmp.c:4: the file defines its own bcmp' own_bcmp.c index_of
refused 'own_floorf.c:4: the file defines its own floorf' own_floorf.c index_of
refused 'own_ceilf.c:4: the file defines its own ceilf' own_ceilf.c index_of
refused 'assembly.c: assembly outside of functions' assembly.c index_of
c other_name "static __attribute__((noinline)) void *copy$copies"
c direct 'static __attribute__((noinline)) float ceilf(float x) { return x >= 1 ? 0 : 0.5f; }
INDEX { return (unsigned)ceilf(u) + (unsigned)__builtin_floorf(u); }'
for name in other_name direct; do holds $name.c index_of; done

# A file's own functions that compilers take for the library's, because of their names.
taken='(int x) { return x == 0 ? -1 : 0; } INDEX { return (unsigned)'
c own_ffs "__attribute__((noinline)) int ffs$taken(ffs(THERE) + THERE * 0) & THERE; }"
c own_toascii "__attribute__((noinline)) int toascii$taken(toascii(THERE ? 200 : 0)) & 1; }"
c own_labs "__attribute__((noinline)) long labs(long x) { return x; } INDEX { return labs(-(long)THERE) < 0; }"
for name in ffs toascii labs; do
  refused "own_$name.c:4: the file defines its own $name, which compilers take for the library's; make it static" own_$name.c index_of
  sed 's/^__attribute__((noinline))/static &/' own_$name.c >static_$name.c
  judged 0 '^holds' static_$name.c index_of
done

# Floats in registers of another precision, and sums in another order.
c no_sse2 '__attribute__((target("no-sse2"))) INDEX { double a = u, b = v; return (unsigned)(a + b - a - b + 0.5); }'
c callee_no_sse2 '__attribute__((noinline, target("no-sse2"))) static void add(double *a, const double *b) { *a += *b; }
INDEX { double a = u, b = v; add(&a, &b); return 0 * (unsigned)a; }'
refused 'no_sse2.c:4: the target feature -sse2?: ' no_sse2.c index_of
refused 'callee_no_sse2.c:4: the target feature -sse2?: ' callee_no_sse2.c index_of
refused 'the target feature -sse2?: ' other_name.c index_of --flag=-mno-sse2
holds other_name.c index_of --flag=-mno-avx --flag=-mavx2
for pragma in 'vectorize(enable)' 'vectorize_width(4)' 'interleave_count(2)' 'interleave(enable)'; do
  c reordered "INDEX { float s[8] = {u, v, 1e9f, 1, -1e9f, u, v, 1}, sum = 0;
_Pragma(\"clang loop $pragma\")
for (int k = 0; k < 8; ++k) sum += s[k];
return 0 * (sum > 0); }"
  refused 'reordered.c:6: an operation of floats in a loop whose pragma lets compilers reorder it' reordered.c index_of
done
c integers 'INDEX { unsigned s[4] = {1, 2, 3, (unsigned)(u * 0)}, sum = 0;
_Pragma("clang loop vectorize(enable)")
for (int k = 0; k < 4; ++k) sum += s[k];
return sum - 6; }'
c unrolled 'INDEX { float sum = u - u;
_Pragma("clang loop unroll(enable)")
for (int k = 0; k < 4; ++k) sum += 0;
return (unsigned)sum; }'
for name in integers unrolled; do holds $name.c index_of; done

# A tail call that reads its caller's variable, and memory that a tag calls constant.
for tail in tail ''; do
  printf '%s\n' 'define i32 @index_of(i32 %level, float %u, float %v) {' '%p = alloca i32' 'store i32 0, i32* %p' \
    "%x = $tail call i32 @get(i32* %p)" 'ret i32 %x' '}' \
    'define internal i32 @get(i32* %p) noinline {' '%x = load i32, i32* %p' 'ret i32 %x' '}' >"${tail:-plain}_call.ll"
done
refused 'tail_call.ll: .*a tail call that may use variables of its caller' tail_call.ll index_of
holds plain_call.ll index_of
for constant in 0 1; do
  printf '%s\n' 'define i32 @index_of(i32 %level, float %u, float %v) {' '%p = alloca i32' 'store i32 0, i32* %p' \
    '%x = load i32, i32* %p, !tbaa !0' 'ret i32 %x' '}' "!0 = !{!1, !1, i64 0, i64 $constant}" \
    '!1 = !{!"int", !2}' '!2 = !{!"root"}' >"tag_$constant.ll"
done
holds tag_0.ll index_of
refused 'tag_1.ll: .*says that memory is constant' tag_1.ll index_of

# The size of a workgroup is that of the dispatch.
if command -v glslangValidator >/dev/null; then
  printf 'uint index(uint level, float u, float v) { return gl_WorkGroupSize.x - 64u; }\n' >group.glsl
  holds group.glsl index
fi

# Copies of no bytes from or to null.
begin="#include <string.h>
$begin"
c moved_null 'INDEX { unsigned r = 0; const int n = THERE; memcpy(&r, n ? 0 : &u, 0); return r; }'
c filled_null 'INDEX { if (THERE) memset(0, 0, (size_t)level); return 0; }'
c moved_none 'INDEX { unsigned r = 0; const int n = THERE; memmove(&r, &r, 4 - 4 * (size_t)n); return r; }'
judged 1 '^refuted' moved_null.c index_of
refused 'filled_null.c:5: call of llvm.memset' filled_null.c index_of
holds moved_none.c index_of
begin=${begin#*$'\n'}

# Code that a compiler puts in.
for flag in -pg -mfentry -finstrument-functions -finstrument-functions-after-inlining -ftrap-function=mine \
  -fpatchable-function-entry=2 -fprofile-generate -fprofile-arcs --coverage -fsanitize=address -fsanitize-coverage=trace-pc-guard \
  -fxray-instrument -ffixed-point -mllvm; do
  refused "plain.c: --flag=$flag: " plain.c index_of "--flag=$flag"
done
for flag in -O2 -fno-builtin -mms-bitfields -fstack-protector-strong -funroll-loops; do holds plain.c index_of "--flag=$flag"; done
c patched '__attribute__((patchable_function_entry(3))) INDEX { return 0; }'
refused 'patched.c:4: the attribute "patchable-function' patched.c index_of

# Definitions that others replace, and what is defined nowhere.
c weak '__attribute__((weak)) unsigned off(float u) { return 0; } INDEX { return off(u); }'
c inline 'inline unsigned off(float u) { return 0; } INDEX { return off(u); }'
refused 'weak.c:4: the function off, which another definition may replace' weak.c index_of
refused 'inline.c:4: the function off, which another definition may replace' inline.c index_of
printf 'inline unsigned off(float u) { return 0; } unsigned index_of(unsigned level, float u, float v) { return off(u); }\n' >inline.cpp
holds inline.cpp index_of
c elsewhere 'typedef unsigned __attribute__((address_space(270))) *Short;
INDEX { unsigned x = 0, *p = &x; if (THERE) p = (unsigned *)(Short)p; return *p; }'
refused 'elsewhere.c:5: a pointer of another address space' elsewhere.c index_of

# Functions that say that they read or write no memory.
c const_lie 'static __attribute__((const, noinline)) unsigned at(const unsigned *p) { return *p; }
INDEX { unsigned x = 0, a = at(&x); x = THERE; return (a ^ at(&x)) & 2; }'
c const_true 'static __attribute__((const, noinline)) unsigned more(unsigned x) { unsigned y[2] = {x, 0}; return y[1]; }
static __attribute__((pure, noinline)) unsigned at(const unsigned *p) { return *p; }
INDEX { unsigned x = more(THERE); return at(&x); }'
refused 'const_lie.c:[0-9]: the attribute readnone, which does not follow' const_lie.c index_of
holds const_true.c index_of

# LLVM's assembly: `x` is 1 there and 0 elsewhere.
ll() {
  { printf '%s\ndefine i32 @index_of(i32 %%level, float %%u, float %%v) %s {\n  %%a = fcmp oeq float %%u, 0x3FD3333340000000
  %%b = fcmp oeq float %%v, 0x3FD0002A00000000\n  %%c = and i1 %%a, %%b\n  %%x = zext i1 %%c to i32\n%s\n}\n' "${3-}" "${4-}" "$2"; } >"$1.ll"
}
variable='  %t = alloca i32
  store i32 0, i32* %t
  %y = call i32 @g(i32* %t, i32 %x)
  ret i32 0'
writes='noinline { store i32 %x, i32* %p
  ret i32 0 }'
ll prologue '  ret i32 0' '' 'prologue i8 0'
ll prefix '  ret i32 0' '' 'prefix i8 0'
refused 'prologue.ll: index_of has bytes of its own before its code' prologue.ll index_of
refused 'prefix.ll: index_of has bytes of its own before its code' prefix.ll index_of
for bound in 1 2; do
  ll range_$bound '  %y = call i32 @g(i32 %x), !range !0
  ret i32 0' "define internal i32 @g(i32 %x) noinline { ret i32 %x }
!0 = !{i32 0, i32 $bound}"
done
judged 1 'undefined: a value that its type does not have' range_1.ll index_of
holds range_2.ll index_of
ll invariant_lie '  %t = alloca i32
  store i32 %x, i32* %t
  %y = load i32, i32* %t, !invariant.load !0
  ret i32 0' '!0 = !{}'
ll invariant '  %p = getelementptr inbounds [2 x i32], [2 x i32]* @t, i32 0, i32 %x
  %y = load i32, i32* %p, !invariant.load !0
  ret i32 %y' '!0 = !{}
@t = internal constant [2 x i32] zeroinitializer'
refused 'invariant_lie.ll: !invariant.load of what may change' invariant_lie.ll index_of
holds invariant.ll index_of
ll inexact '  %q = fdiv float %u, 4.0, !fpmath !0
  %i = fptoui float %q to i32
  ret i32 %i' '!0 = !{float 2.5}'
refused 'inexact.ll: the promise !fpmath' inexact.ll index_of
ll parallel '  %t = alloca i32
  store i32 0, i32* %t, !llvm.access.group !0
  ret i32 0' '!0 = distinct !{}'
refused 'parallel.ll: the promise !llvm.access.group' parallel.ll index_of
ll readonly_lie "$variable" "define internal i32 @g(i32* readonly %p, i32 %x) $writes"
ll nocapture "$variable" "define internal i32 @g(i32* nocapture %p, i32 %x) nofree $writes"
ll readonly "$variable" 'define internal i32 @g(i32* nocapture readonly %p, i32 %x) readonly noinline { %y = load i32, i32* %p
  ret i32 %y }'
refused 'readonly_lie.ll: the attribute readonly, which does not follow' readonly_lie.ll index_of
for name in nocapture readonly; do holds $name.ll index_of; done
ll returned_lie '  %y = call i32 @g(i32 %x)
  ret i32 0' 'define internal i32 @g(i32 returned %x) noinline { ret i32 5 }'
ll returned '  %y = call i32 @g(i32 %x)
  ret i32 0' 'define internal i32 @g(i32 returned %x) noinline { ret i32 %x }'
refused 'returned_lie.ll: the attribute returned, which does not follow' returned_lie.ll index_of
holds returned.ll index_of
for kind in linkonce linkonce_odr; do
  ll $kind '  %y = call i32 @g()
  ret i32 %y' "define $kind i32 @g() { ret i32 0 }"
done
refused 'linkonce.ll: the function g, which another definition may replace' linkonce.ll index_of
holds linkonce_odr.ll index_of
loads='  %y = load i32, i32* @t
  %z = and i32 %y, %x
  ret i32 %z'
ll weak_constant "$loads" '@t = weak constant i32 0'
ll external "$loads" '@t = external constant i32'
refused 'weak_constant.ll: t, which another definition may replace' weak_constant.ll index_of
refused 'external.ll: the symbol t is defined nowhere' external.ll index_of
for value in null '@n'; do
  ll "nonnull_${value/@/}" "  %t = alloca i32*
  store i32* $value, i32** %t
  %p = load i32*, i32** %t, !nonnull !0
  ret i32 0" '!0 = !{}
@n = internal constant i32 0'
done
judged 1 '^refuted' nonnull_null.ll index_of
holds nonnull_n.ll index_of

# SPIR-V: sp NAME DECORATIONS BODY [FUNCTION]: `x` is 1 there and 0 elsewhere, the body gives `r`.
sp() {
  cat >"$1.spvasm" <<TEXT
OpCapability Shader
%ext = OpExtInstImport "GLSL.std.450"
OpMemoryModel Logical GLSL450
OpEntryPoint GLCompute %main "main"
OpExecutionMode %main LocalSize 1 1 1
OpName %index "index"
$2
%void = OpTypeVoid
%uint = OpTypeInt 32 0
%float = OpTypeFloat 32
%bool = OpTypeBool
%pair = OpTypeVector %uint 2
%of_floats = OpTypeVector %float 2
%pointer = OpTypePointer Function %uint
%of_nothing = OpTypeFunction %void
%of_point = OpTypeFunction %uint %uint %float %float
%of_pointer = OpTypeFunction %uint %pointer
%u_there = OpConstant %float 0.300000012
%v_there = OpConstant %float 0.250010014
%zero = OpConstant %uint 0
%one = OpConstant %uint 1
%half = OpConstant %uint 0x7fffffff
%most = OpConstant %uint 0xffffffff
%unset = OpUndef %uint
%main = OpFunction %void None %of_nothing
%in_main = OpLabel
OpReturn
OpFunctionEnd
${4-}
%index = OpFunction %uint None %of_point
%level = OpFunctionParameter %uint
%u = OpFunctionParameter %float
%v = OpFunctionParameter %float
%entry = OpLabel
%p = OpVariable %pointer Function %zero
%a = OpFOrdEqual %bool %u %u_there
%b = OpFOrdEqual %bool %v %v_there
%c = OpLogicalAnd %bool %a %b
%x = OpSelect %uint %c %one %zero
$3
OpReturnValue %r
OpFunctionEnd
TEXT
  spirv-as --target-env spv1.4 -o "$1.spv" "$1.spvasm"
}
if command -v spirv-as >/dev/null; then
  nothing='%r = OpCopyObject %uint %zero'
  loop() { # CONTROL: a loop that ends after x turns
    cat <<TEXT
OpBranch %head
%head = OpLabel
%k = OpPhi %uint %zero %entry %next %more
OpLoopMerge %end %more $1
OpBranch %test
%test = OpLabel
%on = OpULessThan %bool %k %x
OpBranchConditional %on %more %end
%more = OpLabel
%next = OpIAdd %uint %k %one
OpBranch %head
%end = OpLabel
$nothing
TEXT
  }
  reads() { # CONTROL DECORATION: a function that reads through its pointer
    sp "$3" "${2:+OpDecorate %q $2}" '%r = OpFunctionCall %uint %g %p' "%g = OpFunction %uint $1 %of_pointer
%q = OpFunctionParameter %pointer
%in_g = OpLabel
%y = OpLoad %uint %q
OpReturnValue %y
OpFunctionEnd"
  }
  sp wraps 'OpDecorate %s NoUnsignedWrap' "%s = OpIAdd %uint %x %most
$nothing"
  sp overflows 'OpDecorate %s NoSignedWrap' "%s = OpIMul %uint %x %half
%d = OpISub %uint %zero %x
$nothing"
  sed 's/OpIMul %uint %x %half/OpIAdd %uint %x %half/' overflows.spvasm >overflows_by_one.spvasm
  spirv-as --target-env spv1.4 -o overflows_by_one.spv overflows_by_one.spvasm
  sp shifts 'OpDecorate %s NoSignedWrap' "%s = OpShiftLeftLogical %uint %x %one
$nothing"
  judged 1 'undefined: a sum, difference or product that does not fit' wraps.spv index
  judged 1 'undefined: a sum, difference or product that does not fit' overflows_by_one.spv index
  holds overflows.spv index
  refused 'shifts.spv: NoSignedWrap or NoUnsignedWrap of OpShiftLeftLogical' shifts.spv index
  for control in 'MaxIterations 3' 'MinIterations 4' 'IterationMultiple 2' 'PeelCount 1' DependencyInfinite; do
    sp loop '' "$(loop "$control")"
    refused "loop.spv: $control: a promise" loop.spv index
  done
  for decoration in Restrict Volatile Coherent; do
    reads None "$decoration" reads
    refused "reads.spv: $decoration: a promise" reads.spv index
  done
  for control in Const Pure 'Pure|Const'; do
    reads "$control" '' reads
    refused "reads.spv: ${control/|/\\|} of a function: a promise" reads.spv index
  done
  reads 'Inline|DontInline' Aliased reads
  holds reads.spv index
  for decoration in NonWritable Restrict; do
    sp variable "OpDecorate %p $decoration" "$nothing"
    refused "variable.spv: $decoration: a promise" variable.spv index
  done
  for access in 'Aligned 4' Volatile; do
    sp access '' "%r = OpLoad %uint %p $access"
    refused "access.spv: $access: a promise" access.spv index
  done
  sp access '' 'OpStore %p %zero Nontemporal
%r = OpLoad %uint %p Nontemporal'
  holds access.spv index
  sp group 'OpDecorate %all RelaxedPrecision
%all = OpDecorationGroup
OpGroupDecorate %all %r' '%r = OpIAdd %uint %zero %zero'
  refused 'group.spv: RelaxedPrecision' group.spv index
  # The compiled library defines the function that stands for a value that is not set.
  sp undef '' '%s = OpSelect %uint %c %unset %zero
%r = OpBitwiseAnd %uint %s %one'
  sp undef_elsewhere '' '%s = OpSelect %uint %c %zero %unset
%r = OpSelect %uint %c %s %zero'
  sp shuffle '' '%w = OpCompositeConstruct %pair %zero %zero
%s = OpVectorShuffle %pair %w %w 0 0xFFFFFFFF
%y = OpVectorExtractDynamic %uint %s %x
%r = OpBitwiseAnd %uint %y %one'
  for name in undef shuffle; do judged 1 'undefined: a value that was never set' $name.spv index; done
  holds undef_elsewhere.spv index
  sp quantize '' '%y = OpQuantizeToF16 %float %u
%r = OpConvertFToU %uint %y'
  sp pack '' '%y = OpCompositeConstruct %of_floats %u %v
%r = OpExtInst %uint %ext PackHalf2x16 %y'
  sp aliased 'OpDecorate %p Aliased' "$nothing"
  holds aliased.spv index
  refused 'quantize.spv: (OpQuantizeToF16|opcode 116)$' quantize.spv index
  refused 'pack.spv: (PackHalf2x16|instruction 58) of GLSL.std.450$' pack.spv index
else
  echo 'SPIR-V: left out, no spirv-as'
fi
if command -v glslangValidator >/dev/null; then
  echo 'const mediump float t[2] = float[2](0.25, 0.5); uint index(uint level, float u, float v) { return t[level + 1u] != v ? 0u : 1u; }' >medium.glsl
  refused 'medium.glsl:?[0-9]*: RelaxedPrecision' medium.glsl index
  for attribute in 'max_iterations(2)' unroll; do
    printf '#extension GL_EXT_control_flow_attributes : enable\nuint index(uint level, float u, float v) {\n  uint s = 0u; [[%s]] for (uint k = 0u; k < 3u; ++k) s += k; return s ^ 3u; }\n' \
      "$attribute" >"${attribute%(*}.glsl"
  done
  judged 2 "max_iterations.glsl:3: 'max_iterations' : an attribute that nothing checks" max_iterations.glsl index
  holds unroll.glsl index
fi
# The compiler's complaint in one line.
printf 'float __builtin_canonicalizef(float); unsigned index_of(unsigned level, float u, float v) { return (unsigned)__builtin_canonicalizef(u); }\n' >canonical.c
judged 2 'canonical.c: clang makes no shared library of it \(exit code [0-9]+\): [^\\]*$' canonical.c index_of
c variable 'unsigned *kept; INDEX { unsigned x[4] = {0};
unsigned *p = &x[0]; __asm__("" : "+r"(p)); return (unsigned)((unsigned long)p & 4) * THERE; }'
refused 'variable.c:[0-9]+: ' variable.c index_of
((failures == 0)) || { echo "$failures failed"; exit 1; }
echo 'source_promises_test: all named or refuted, and the right ones hold'
