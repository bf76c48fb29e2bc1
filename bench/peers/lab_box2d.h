// SPDX-License-Identifier: MIT
// lab_box2d.h -- Box2D v3 as the engine of a lab.
#ifndef LAB_BOX2D_H
#define LAB_BOX2D_H
#include "validate/lab.h"

extern const LabEngine box2d_lab;

#endif
