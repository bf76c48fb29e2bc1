// SPDX-License-Identifier: MIT
// upload.h -- uploads what the user changed.
#ifndef UPLOAD_H
#define UPLOAD_H
#include "scree/scree.h"

// Sends everything that the user changed since the last call to the device. Called before anything is read back.
scree_status world_upload(scree_world* world);

// The same before a step. Only then chains are found anew: joints that a chain takes in or lets go begin without impulses, so a read between
// two changes would show in the next step.
scree_status world_upload_to_step(scree_world* world);

#endif
