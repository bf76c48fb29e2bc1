// SPDX-License-Identifier: MIT
// swept.h -- pushes movers out of the way of kinematic bodies that swept over them in the last step.
#ifndef SWEPT_H
#define SWEPT_H
#include "api/mover/mover_slide.h"

// Pushes movers before they move on their own. A pushed mover that hits a static collidable is crushed. dt: duration of
// the step, s.
scree_status mover_swept(MoverCall* call, float dt);

#endif
