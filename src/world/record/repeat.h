// SPDX-License-Identifier: MIT
// repeat.h -- makes a call of a recording again.
#ifndef REPEAT_H
#define REPEAT_H
#include "world/record/call_codec.h"

// Makes a call with the arguments of a record, through the public function, and returns its status.
scree_status call_repeat(scree_world* world, const CallArguments* arguments);

#endif
