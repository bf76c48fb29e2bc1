// SPDX-License-Identifier: MIT
// swept.h -- pushes movers out of the way of kinematic bodies that swept over them in the last step.
#ifndef SWEPT_H
#define SWEPT_H
#include "api/mover/mover_slide.h"

// Moves the movers that a kinematic body hit during the last step, of dt seconds, out of the way of this body. Movers
// that a static collidable stops are crushed. Called before anything else moves.
scree_status mover_swept(MoverCall* call, float dt);

#endif
