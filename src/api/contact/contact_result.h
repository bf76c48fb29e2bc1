// SPDX-License-Identifier: MIT
// contact_result.h -- converts a contact report to the contact that the user reads.
#ifndef CONTACT_RESULT_H
#define CONTACT_RESULT_H
#include "world/world.h"

// Returns the contact of a row from the device, without handles and user words. details: true to set contact.details.
scree_contact contact_result(const ContactReport* row, bool details);

#endif
