// SPDX-License-Identifier: MIT
// own_host.h -- declares the host data of a template with the own values of one of its worlds.
#ifndef OWN_HOST_H
#define OWN_HOST_H
#include "batch/template.h"

// Makes a copy of a template's world with bodies and joints of its own. It shares all other memory with the template.
scree_status own_host_open(scree_world** made, const scree_world* world);
void own_host_close(scree_world* made);

// Gives the copy the own values of a world: masses and what follows from them, disabled bodies and joints.
void own_host_set(scree_world* made, const Template* from, Own own);

#endif
