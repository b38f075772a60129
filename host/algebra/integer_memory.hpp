// integer_memory.hpp - where GMP keeps its numbers: most of ours are a few words long and live for a few lines.
// Why      malloc and free took a sixth of the time from text to job.
// How      Blocks of up to 136 bytes wait for their next use in a list a size, one set of lists a thread; longer ones are malloc's.
#pragma once

namespace halfspace {

// For the whole program; to be called before it has a number.
void keep_integer_memory();

}  // namespace halfspace
