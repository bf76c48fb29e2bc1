// SPDX-License-Identifier: MIT
// contacts.h -- finds the touching contacts in a box.
#ifndef CONTACTS_H
#define CONTACTS_H
#include "scree/scree.h"

// Reads the touching contacts between bodies, in the order of scree_world_get_contacts, into new memory, which the caller
// releases, also after a failure. Omits only contacts that have no point in the box. The user's changes must be uploaded.
scree_status contacts_find(scree_world* world, const char* function, const scree_box* view, scree_contact** contacts,
                           int* count);

#endif
