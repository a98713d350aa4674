#!/usr/bin/env bash
# The manual page and the completions have all that --help shows, and a bash completes by them.  zsh, fish and mandoc are
# asked where they are.
# usage: tests/outside/describe_test.sh MMVERIFY
set -euo pipefail

(($# == 1)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
PATH=$(dirname -- "$(readlink -f -- "$1")"):$PATH
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
cd "$folder"

SOURCE_DATE_EPOCH=1700000000 mmverify man >mmverify.1
for shell in bash zsh fish; do mmverify completion "$shell" >"in.$shell"; done
grep -q '^.TH MMVERIFY 1 "2023-11-14" "mmverify [0-9.]*" "User Commands"$' mmverify.1 || fail "the page's head"
if command -v mandoc >/dev/null; then
  mandoc -T lint -W warning mmverify.1 || fail "mandoc warns"
else
  echo "skipped: no mandoc to read the manual page: ./run install test"
fi
if command -v man >/dev/null && command -v groff >/dev/null; then
  warnings=$(LC_ALL=C.UTF-8 MANROFFSEQ='' man --warnings -l mmverify.1 2>&1 >/dev/null)
  [[ -z $warnings ]] || fail "man warns: $warnings"
fi

# complete_words WORD...: what bash offers for the last.
# shellcheck disable=SC1091  # written above
. ./in.bash
[[ $(complete -p mmverify) == 'complete -F _mmverify mmverify' ]] || fail "$(complete -p mmverify)"
complete_words() {
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  _mmverify
  printf '%s\n' "${COMPREPLY[@]}"
}

# Of each command all of its options, which are read from --help, not from where the three have them.
mapfile -t commands < <(mmverify --help | sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p')
((${#commands[@]} > 10)) || fail "--help shows ${#commands[@]} commands"
diff <(printf '%s\n' "${commands[@]}") <(complete_words mmverify '') || fail "--help's commands (<), bash's (>)"
options=0
for command in "${commands[@]}"; do
  mmverify "$command" --help | grep -oE '^  (-[a-z],)?--[a-z0-9-]+(,--[a-z0-9-]+)?|^  -[a-z]\b' | tr -d ' ' | tr , '\n' >options
  diff <(sort options) <(complete_words mmverify "$command" - | sort) || fail "$command: --help's options (<), bash's (>)"
  page=$(sed "1,/^\.SS mmverify $command\$/d" mmverify.1 | sed '/^\.S[SH]/,$d')
  # Its example has no option but its own.
  example=$(sed -n '/^Example:$/,$p' <<<"$page" | sed -n '/^.nf$/{n;s/\\-/-/g;s/ | .*//;p}')
  [[ $example == *"mmverify $command"* ]] || fail "$command has no example on the manual page"
  for option in $(grep -oE -- ' --?[a-z][a-z-]*' <<<"$example"); do
    grep -qx -- "$option" options || fail "$command: its example has $option"
  done
  zsh=$(sed -n "/^    $command)\$/,/^      ;;/p" in.zsh)
  fish=$(grep "__fish_seen_subcommand_from $command'" in.fish)
  while read -r option; do
    [[ $page == *"fB${option//-/\\-}\\fR"* ]] || fail "$command $option is not on the manual page"
    [[ $zsh == *"'${option}["* || $zsh == *"'*${option}["* ]] || fail "$command $option: not for zsh"
    if [[ $option == --* ]]; then name="-l ${option#--} "; else name="-s ${option#-} "; fi
    [[ $fish == *" $name"* ]] || fail "$command $option: not for fish"
    options=$((options + 1))
  done <options
done

# offered EXPECTED WORD...
offered() {
  local expected=$1 got
  shift
  got=$(complete_words "$@" | paste -sd ' ')
  [[ $got == "$expected" ]] || fail "$*: offered '$got', not '$expected'"
}
touch 'a file' result.json
offered 'validate' mmverify val
offered '--version' mmverify --v
offered 'fast long' mmverify prove --tier ''
offered 'long' mmverify prove --tier = l
offered 'index.equals_reference' mmverify prove --tier fast index.equals_r
offered 'index.equals_reference' mmverify prove tree.round_trip --quiet index.equals_r
offered 'step-f16' mmverify prove --subject step-f1
offered 'a file' mmverify prove --json 'a '
offered '' mmverify prove --levels ''
offered 'maps' mmverify check ma
offered 'result.json' mmverify check maps res
offered '' mmverify gen index ind
offered 'result.json' mmverify report result.json --output page.html re
offered '--exhaustive' mmverify check maps --ex
offered 'bash zsh fish' mmverify completion ''
offered '' mmverify nothing ''

# At a terminal, by the key itself.
python3 - in.bash <<'PYTHON' || fail "no completion at a terminal"
import os, pty, select, sys, time
child, terminal = pty.fork()
if child == 0:
    os.execvp("bash", ["bash", "--norc", "--noprofile", "-i"])
os.write(terminal, f"PS1='> '; source {sys.argv[1]}; echo rea''dy\n".encode())
seen = b""
def wait_for(text):
    global seen
    until = time.monotonic() + 60
    while text not in seen and time.monotonic() < until:
        if select.select([terminal], [], [], 1)[0]:
            seen += os.read(terminal, 4096)
    return text in seen
found = wait_for(b"ready\r\n")
os.write(terminal, b"echo mmv''erify; mmverify prove --tier lo\t")
found = found and wait_for(b"--tier long ")
os.write(terminal, b"\x03\x04")
os.close(terminal)
os.waitpid(child, 0)
sys.exit(not found)
PYTHON

if command -v zsh >/dev/null; then
  zsh -n in.zsh || fail "zsh cannot read its completion"
else
  echo "skipped: no zsh to read its completion: ./run install test"
fi
if command -v fish >/dev/null; then
  got=$(HOME=$folder fish -c 'source in.fish; complete -C "mmverify prove --tier "' | cut -f1 | sort | paste -sd ' ')
  [[ $got == 'fast long' ]] || fail "fish offers '$got'"
else
  echo "skipped: no fish to read its completion: ./run install test"
fi

# A day that is none, and a shell that is none.
code=0
SOURCE_DATE_EPOCH=today mmverify man >no.1 2>complaint || code=$?
[[ $code == 2 && ! -s no.1 && $(<complaint) == *SOURCE_DATE_EPOCH* ]] || fail "SOURCE_DATE_EPOCH=today: exit code $code"
code=0
mmverify completion csh >no.csh 2>complaint || code=$?
[[ $code == 2 && ! -s no.csh ]] || fail "completion csh: exit code $code"
echo "${#commands[@]} commands, $options options in --help, on the manual page and in three shells"
