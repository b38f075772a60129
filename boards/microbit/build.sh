#!/bin/sh
# build.sh OUT_DIR JOB.cpp... - cross-builds the firmware once and links it with each job: OUT_DIR/<job>.elf.
# A job file defines halfspace::embedded_job (firmware/app/embedded_job.hpp); tests/board/make_job writes such files.
set -eu

root=$(cd "$(dirname "$0")/../.." && pwd)
out=$1
shift
cxx=arm-none-eabi-g++
if ! command -v $cxx > /dev/null; then
  echo "error: $cxx is missing: apt-get install gcc-arm-none-eabi libstdc++-arm-none-eabi-dev libnewlib-dev" >&2
  exit 1
fi

machine="-mcpu=cortex-m0 -mthumb"
flags="-std=c++20 -Os $machine -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit
  -ffunction-sections -fdata-sections -fstack-usage -Wall -Wextra -Wpedantic -Wshadow -Werror -I$root"

mkdir -p "$out/objects"
objects=
for source in "$root"/firmware/core/*.cpp "$root"/firmware/app/*.cpp "$root"/boards/cortex_m/*.cpp \
  "$root"/boards/microbit/*.cpp; do
  object=$out/objects/$(basename "$(dirname "$source")")-$(basename "$source" .cpp).o
  $cxx $flags -c "$source" -o "$object"
  objects="$objects $object"
done
for job in "$@"; do
  name=$(basename "$job" .cpp)
  $cxx $flags -c "$job" -o "$out/objects/$name.o"
  $cxx $machine -nostdlib -nostartfiles -Wl,--gc-sections -Wl,-Map="$out/$name.map" \
    -T "$root/boards/microbit/microbit.ld" $objects "$out/objects/$name.o" -lgcc -o "$out/$name.elf"
done
