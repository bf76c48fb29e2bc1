// SPDX-License-Identifier: MIT
// device_switch.h -- moves the world to the next device, for a key.
#ifndef DEVICE_SWITCH_H
#define DEVICE_SWITCH_H
#include "view/window/window_state.h"

// Moves the world to the next other device, or selects "auto". Each call tries the device after that of the last call,
// so that a device that fails does not block the others. If there is only one device, it shows a message.
void devices_next(Viewer* viewer);

#endif
