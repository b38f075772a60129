#!/bin/sh
# build.sh OUT_DIR - cross-builds the measuring program for a Cortex-M3: OUT_DIR/mps2-an385.elf.
set -eu

root=$(cd "$(dirname "$0")/../.." && pwd)
out=$1
cxx=arm-none-eabi-g++
if ! command -v $cxx > /dev/null; then
  echo "error: $cxx is missing: apt-get install gcc-arm-none-eabi libstdc++-arm-none-eabi-dev libnewlib-dev" >&2
  exit 1
fi

machine="-mcpu=cortex-m3 -mthumb"
flags="-std=c++20 -O2 $machine -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-use-cxa-atexit
  -ffunction-sections -fdata-sections -Wall -Wextra -Wpedantic -Wshadow -Werror -I$root"

mkdir -p "$out/objects"
objects=
for source in "$root"/firmware/core/*.cpp "$root"/firmware/app/report.cpp "$root"/boards/cortex_m/*.cpp \
  "$root"/boards/mps2-an385/*.cpp; do
  object=$out/objects/$(basename "$(dirname "$source")")-$(basename "$source" .cpp).o
  $cxx $flags -c "$source" -o "$object"
  objects="$objects $object"
done
$cxx $machine -nostdlib -nostartfiles -Wl,--gc-sections -T "$root/boards/mps2-an385/mps2-an385.ld" $objects -lgcc \
  -o "$out/mps2-an385.elf"
