// SPDX-License-Identifier: MIT
// environment.h -- sets variables of the environment.
#ifndef ENVIRONMENT_H
#define ENVIRONMENT_H
#include <stdlib.h>

// value: null removes the variable
static inline void set_environment(const char* name, const char* value)
{
#ifdef _WIN32
	_putenv_s(name, value ? value : "");
#else
	if (value)
		setenv(name, value, 1);
	else
		unsetenv(name);
#endif
}

#endif
