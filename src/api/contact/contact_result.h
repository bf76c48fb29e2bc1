// SPDX-License-Identifier: MIT
// contact_result.h -- converts contacts for the user.
#ifndef CONTACT_RESULT_H
#define CONTACT_RESULT_H
#include "world/world.h"

// Converts a row of the device, without handles. details: includes the impulses and speeds of the last step.
scree_contact contact_result(const ContactReport* row, bool details);

#endif
