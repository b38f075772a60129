// Compiled for the precompiled header alone, which all test programs share.
