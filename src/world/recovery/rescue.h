// SPDX-License-Identifier: MIT
// rescue.h -- makes a world whole again on the CPU, after its device has failed.
#ifndef RESCUE_H
#define RESCUE_H
#include "world/recovery/kept_state.h"

// Brings a world whose device has failed to the CPU: into the kept state, and through the calls since. Logs one warning. The failed
// device is closed. On failure the world stays broken, and the message has both causes; a later call may succeed.
scree_status world_rescue(scree_world* world, const char* function, const KeptState* kept);

#endif
