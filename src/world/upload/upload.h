// SPDX-License-Identifier: MIT
// upload.h -- uploads the user's changes.
#ifndef UPLOAD_H
#define UPLOAD_H
#include "scree/scree.h"

// Uploads all changes that the user has made since the last upload. Called before every readback.
scree_status world_upload(scree_world* world);

// Uploads all changes before a step, and finds changed chains again. world_upload does not find chains: otherwise a
// readback would change later impulses.
scree_status world_upload_to_step(scree_world* world);

#endif
