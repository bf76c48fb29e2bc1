// SPDX-License-Identifier: MIT
// device_switch.h -- which device the world goes to next, by a key.
#ifndef DEVICE_SWITCH_H
#define DEVICE_SWITCH_H
#include "view/window/window_state.h"

// Moves the world to the next device that is not the one where it is, or lets it choose. Each call tries the device after the one
// tried last, so that a device that fails does not block the others. Where there is one device alone it says so.
void devices_next(Viewer* viewer);

#endif
