// SPDX-License-Identifier: MIT
// device_switch.h -- moves the world to the next device, when the user presses a key.
#ifndef DEVICE_SWITCH_H
#define DEVICE_SWITCH_H
#include "view/window/window_state.h"

// Moves the world to the next device in the list that is not the current device of the world; after the last one,
// selects "auto". Each call begins with the device after the one that the previous call tried, so that a device that
// fails does not block the others. If there is only one device, shows a message.
void devices_next(Viewer* viewer);

#endif
