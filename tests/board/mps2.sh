#!/bin/bash
# mps2.sh HALFSPACE OUT_DIR - every shader, and the baselines, on QEMU's mps2-an385: the page has the host's bytes. Words that name no
# shader or no job are refused.
set -u
export LC_ALL=C

halfspace=$1
out=$2
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/tests/board/common.sh"

# shader, stride, job
run_board() { emulate mps2-an385 mps2-an385.elf ",arg=$1,arg=$2,arg=$3" > log 2>&1; }

# FNV-1a of a bitmap's rows: P4's are a band's bytes.
hash_of() {
  python3 -c 'import sys
body = open(sys.argv[1], "rb").read().split(b"\n", 2)[2]
h = 2166136261
for byte in body:
    h = (h ^ byte) * 16777619 % 2**32
print(h)' "$1"
}

# job, shader of the board, stride, shader of the host
check() {
  "$halfspace" run "$1.hsj" -d versatec --shader "$4" ${5:+--stride "$3"} -o "$1.pbm" --quiet || fail "$1 by $4 on the host"
  run_board "$2" "$3" "$1.hsj" || fail "$1 by $2: status $? ($(tr '\n' ' ' < log))"
  [ "$(figure log hash)" = "$(hash_of "$1.pbm")" ] || fail "$1 by $2 differs from $4 on the host"
  printf '%-8s %-3s %8s dots, %6s instructions a dot\n' "$1" "$2" "$(figure log dots)" \
    $((($(figure log enter) + $(figure log shade)) / $(figure log dots)))
}

need_board_programs

rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
"$root/boards/mps2-an385/build.sh" . || exit 1
cat > ball.uq << 'SCENE'
quadric q <1 1 1 0 0 0 .1 .2 0 -9>; body (q); light 1 -.5 .9 -.8; view dop 0 0 -1 whw 3.2 whh 3.2;
SCENE
cat > general.uq << 'SCENE'
quadric e <1 3 .4 .3 -.2 .1 0 0 0 -1>; body (e);
quadric h <1 -.5 1 0 .3 0 -4 0 0 3.2>; plane a <0 1 0 -1.5>; plane b <0 -1 0 -1.5>; body (h a b);
quadric p <1 1 .5 0 0 .4 6 2 0 8>; plane c <0 -1 0 -2>; body (p c);
quadric k <1 -1 1 0 0 0 0 5 0 -6>; plane d <0 1 0 2.5>; plane f <0 -1 0 -5>; body (k d f);
light .1; light .9 -.5 .9 -.8; view dop .2 .1 -1 whw 4 whh 4;
SCENE
for scene in ball.uq general.uq "$root/scenes/tube.uq" "$root/tests/board/ties.uq"; do
  name=$(basename "$scene" .uq)
  "$halfspace" compile "$scene" -d versatec --size 160x160 -o "$name.hsj" --quiet || exit 1
  check "$name" 0 1 isqrt
  check "$name" 1 1 jordan
  check "$name" 2 8 stride with-stride
  check "$name" 3 1 contour
  check "$name" 4 1 auto
  check "$name" A2 1 isqrt
  check "$name" A4 1 isqrt
done
for words in "A5 1 ball.hsj" "0 x ball.hsj" "0 1 none.hsj"; do
  # shellcheck disable=SC2086
  run_board $words && fail "'$words' was drawn"
done
exit $((failures > 0))
