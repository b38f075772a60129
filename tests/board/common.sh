# common.sh - sourced by the tests on emulated boards.
failures=0

fail() {
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}

need_program() { # program, package
  command -v "$1" > /dev/null && return
  echo "FAILED: $1 is missing: apt-get install $2" >&2
  exit 1
}

need_board_programs() {
  need_program arm-none-eabi-g++ "gcc-arm-none-eabi libstdc++-arm-none-eabi-dev libnewlib-dev"
  need_program qemu-system-arm qemu-system-arm
}

# machine, image, further words of its semihosting configuration; its status is the program's
emulate() {
  timeout 120 qemu-system-arm -M "$1" -icount shift=6 -display none -monitor none -serial none \
    -semihosting-config "enable=on,target=native${3:-}" -kernel "$2" < /dev/null
}

figure() { sed -n "s/^$2 //p" "$1"; } # log, name
