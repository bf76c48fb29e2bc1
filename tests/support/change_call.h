// SPDX-License-Identifier: MIT
// change_call.h -- copies a recording with a call that has other arguments, so that its replay differs.
#ifndef CHANGE_CALL_H
#define CHANGE_CALL_H
#include "support/snapshots.h"

// Copies a recording with another bit in the calls of a function that lead to a step. call: name of the function without scree_;
// step: counted from 1; at: byte of the content of the call. The caller frees the bytes of the copy.
Saved change_call(Saved saved, const char* call, int step, size_t at);

#endif
