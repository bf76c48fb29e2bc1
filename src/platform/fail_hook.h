// SPDX-License-Identifier: MIT
// fail_hook.h -- reports failed calls of the user to the hook of scree_fail_hook_set.
#ifndef FAIL_HOOK_H
#define FAIL_HOOK_H
#include "scree/scree.h"

#ifdef SCREE_SMALL // a build for WebAssembly has no hook
#define REPORTED(function, call) return call;
static inline void fail_hook_enter(void) {}
static inline scree_status fail_hook_leave(const char* function, scree_status status) { return (void)function, status; }
#else
#include <stdatomic.h>

extern atomic_bool fail_hooked; // true: there is a hook

// Begins a call on this thread; calls within it are not reported. A thread of the library enters one call and never leaves it.
void fail_hook_enter(void);

// Ends a call and returns its status. Calls the hook if the call is the user's and failed.
scree_status fail_hook_leave(const char* function, scree_status status);

// Returns the status of `call`, and reports a failure. function: name of the public function; "_sized" at its end is left out.
#define REPORTED(function, call)                                   \
	if (!atomic_load_explicit(&fail_hooked, memory_order_relaxed)) \
		return call;                                               \
	fail_hook_enter();                                             \
	return fail_hook_leave(function, call);
#endif

#endif
