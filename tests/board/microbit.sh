#!/bin/bash
# microbit.sh MAKE_JOB OUT_DIR - draws a scene on QEMU's microbit, compares its dots with the host's byte for byte,
# prints what it took, and checks that a job too large for the board is refused with need and have.
# Counts are instructions, not cycles: SysTick under -icount shift=6 (boards/cortex_m/tick_clock.hpp).
set -u
export LC_ALL=C

make_job=$1
out=$2
root=$(cd "$(dirname "$0")/../.." && pwd)
ram_size=16384
flash_size=262144
. "$root/tests/board/common.sh"

# Runs out/$1.elf in a folder of its own; the exit status is the board's.
run_board() {
  mkdir "$1" && cd "$1" || return 1
  emulate microbit "../$1.elf" > log 2>&1
  local status=$?
  cd ..
  return $status
}

# Sections in flash (text, and the values of data), and in RAM (data and bss).
flash_bytes() { arm-none-eabi-size "$1" | awk 'NR == 2 { print $1 + $2 }'; }
static_bytes() { arm-none-eabi-size "$1" | awk 'NR == 2 { print $2 + $3 }'; }

# No soft-float helper and no heap: names that libgcc and the C and C++ libraries give them.
check_symbols() {
  local float='__aeabi_(f|d|cf|cd|h2f|i2f|ui2f|l2f|ul2f|i2d|ui2d|l2d|ul2d)[a-z0-9_]*'
  float+='|__(add|sub|mul|div|neg|eq|ne|lt|le|gt|ge|unord|cmp|pow)[sdt]f[0-9i]*'
  float+='|__(fix|fixuns)[sdt]f[sdt]i|__(float|floatun)[sdt]i[sdt]f|__extend[sdh]f[sdt]f2|__trunc[dt]f[sdh]f2'
  local heap='malloc|calloc|realloc|free|_sbrk|_Zn[wa]j.*|_Zd[la]Pv.*'
  local found
  found=$(arm-none-eabi-nm "$1" | awk '{ print $NF }' | grep -xE "$float|$heap")
  [ -z "$found" ] || fail "$1 links floating point or a heap:" $found
}

# Draws job $1, checks what came of it and prints its line of the table.
check_drawn() {
  local job=$1 log=$1/log
  check_symbols "$job.elf"
  if ! run_board "$job"; then
    fail "$job: the board ended with an error: $(cat "$log")"
    return
  fi
  cmp "$job/dots.bin" "$job.bin" || fail "$job: the board's dots differ from the host's"
  local flash static arena stack stack_size dots instructions ram
  flash=$(flash_bytes "$job.elf")
  static=$(static_bytes "$job.elf")
  arena=$(figure "$log" need_bytes)
  stack=$(figure "$log" stack_bytes)
  stack_size=$(figure "$log" stack_size)
  dots=$(figure "$log" dots)
  instructions=$(($(figure "$log" ticks) * 125 / 128))
  ram=$((static + arena + stack))
  [ "$dots" -gt 0 ] || fail "$job: nothing was shaded"
  [ "$flash" -le $flash_size ] || fail "$job: $flash bytes of flash"
  [ "$ram" -le $ram_size ] || fail "$job: $ram bytes of RAM"
  [ "$stack" -lt "$stack_size" ] || fail "$job: the stack of $stack_size bytes was all used: enlarge it in microbit.ld"
  printf '%-20s %8d %8d %8d %8d %8d %8d %12d %10d\n' "$job" "$flash" "$static" "$arena" "$stack" "$ram" "$dots" \
    "$instructions" $((instructions / dots))
}

# The log's scene is there for the exact arithmetic: it must have been asked, for depths and for levels.
check_exact() {
  local name
  for name in exact_depths exact_levels; do
    [ "$(figure "$1" $name)" -gt 0 ] || fail "$1: $name is 0, so the deepest stack was not measured"
  done
}

# Job $1 needs more than the board has: status 4, both numbers, and not one dot sent.
check_refused() {
  local job=$1 log=$1/log need have
  run_board "$job"
  local status=$?
  [ $status -eq 4 ] || fail "$job: status $status where 4 (refused) was expected: $(cat "$log")"
  need=$(figure "$log" need_bytes)
  have=$(figure "$log" have_bytes)
  if [ "${have:-0}" -le 0 ] || [ "${need:-0}" -le "$have" ]; then fail "$job: need '$need', have '$have'"; fi
  [ ! -e "$job/dots.bin" ] || fail "$job: dots were sent before it was refused"
  echo "$job: refused before drawing, needs $need bytes, has $have"
}

need_board_programs

rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
for shader in isqrt jordan; do
  "$make_job" "$root/scenes/tube.uq" 128x64 17 $shader tube-$shader &&
    "$make_job" "$root/scenes/tube.uq" 640x480 33 $shader tube-640x480-$shader &&
    "$make_job" "$root/tests/board/ties.uq" 127x63 17 $shader ties-$shader || exit 1
done
"$make_job" "$root/scenes/stack_of_bundles.uq" 640x480 65 isqrt too-large || exit 1
drawn=({tube,tube-640x480,ties}-{isqrt,jordan})
"$root/boards/microbit/build.sh" "$out" "${drawn[@]/%/.cpp}" too-large.cpp || exit 1

printf '%-20s %8s %8s %8s %8s %8s %8s %12s %10s\n' "microbit, bytes" flash static arena stack RAM dots \
  instructions "per dot"
for job in "${drawn[@]}"; do check_drawn "$job"; done
check_exact ties-isqrt/log
check_refused too-large
exit $((failures > 0))
