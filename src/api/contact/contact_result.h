// SPDX-License-Identifier: MIT
// contact_result.h -- contacts as users see them.
#ifndef CONTACT_RESULT_H
#define CONTACT_RESULT_H
#include "world/world.h"

// From a row of the device, without names. details: with what it did in the last step.
scree_contact contact_result(const ContactReport* row, bool details);

#endif
