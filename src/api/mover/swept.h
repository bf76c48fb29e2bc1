// SPDX-License-Identifier: MIT
// swept.h -- kinematic bodies that swept over movers in the last step.
#ifndef SWEPT_H
#define SWEPT_H
#include "api/mover/mover_slide.h"

// Before anything moves: movers that a kinematic body met on its way in the last step, of dt seconds, are where it pushes them. Those
// that something static holds there are crushed.
scree_status mover_swept(MoverCall* call, float dt);

#endif
