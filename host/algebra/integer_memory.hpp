// integer_memory.hpp - where GMP keeps its numbers: most of ours are a few words long and live for a few lines.
// Why      malloc and free took a sixth of the time from text to job, and the kernel's pages for long vectors a tenth.
// How      Blocks of up to 136 bytes are cut from larger ones and wait for their next use in a list a size, one set of lists a thread;
//          longer ones are malloc's, which is told to keep what it has: a freed vector's pages serve the next one.
#pragma once

namespace halfspace {

// For the whole program; to be called before it has a number.
void keep_memory();

}  // namespace halfspace
