// SPDX-License-Identifier: MIT
// fixtures.c -- finds fixtures, the scenes made by code, by name.
#include "fixtures.h"
#include <string.h>

static const Fixture* const fixtures[] = {&joint_grid_fixture, &rain_fixture,     &spinner_fixture,
                                          &drum_fixture,       &ropes_fixture,    &bridges_fixture,
                                          &beam_fixture,       &ragdolls_fixture, &car_fixture};

const Fixture* fixture_find(const char* name)
{
	for (size_t k = 0; k < sizeof fixtures / sizeof fixtures[0]; ++k)
	{
		if (strcmp(fixtures[k]->name, name) == 0)
			return fixtures[k];
	}
	return NULL;
}
