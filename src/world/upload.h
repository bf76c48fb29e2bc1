// SPDX-License-Identifier: MIT
// upload.h -- uploads what the user changed.
#ifndef UPLOAD_H
#define UPLOAD_H
#include "scree/scree.h"

// Sends everything that the user changed since the last call to the device. Called before a step and before anything is read
// back.
scree_status world_upload(scree_world* world);

#endif
