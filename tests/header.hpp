// header.hpp - what most tests include and takes longer to read than their own text: precompiled, never included by name.
#pragma once

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <random>
