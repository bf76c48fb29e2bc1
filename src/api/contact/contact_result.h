// SPDX-License-Identifier: MIT
// contact_result.h -- converts a contact report to the contact that the user reads.
#ifndef CONTACT_RESULT_H
#define CONTACT_RESULT_H
#include "world/world.h"

// Returns a contact, without handles, from a row of the device. details: true adds impulses and speeds of the last
// step.
scree_contact contact_result(const ContactReport* row, bool details);

#endif
