// SPDX-License-Identifier: MIT
// gate.c -- tests a device that has no verdict: its arithmetic by 100,000 float results (arithmetic_test.c), then small
// worlds in each form of execution that the device uses (BackendOptions.test).
//
// The arithmetic comes first, because it decides whether the stages are compiled with own rounding, and because its
// program compiles in less than a second. Devices with the same name, driver and platform share a verdict.
#include "opencl/gate.h"
#include "opencl/arithmetic_test.h"
#include "opencl/device_name.h"
#include "opencl/opencl_state.h"
#include "platform/error.h"
#include "platform/processor.h"
#include <string.h>

static scree_status judge_worlds(const BackendOptions* options, Backend* b, Verdict* verdict)
{
	OpenCl* d = b->state;
	SolveForm form = d->form;
	WorldsTest test = {.worlds = 0};
	scree_status status = options->test(b, &test);
	d->form = form;
	d->tiles.stale = true;
	TRY(status);
	double milliseconds[STAGE_COUNT]; // the test must not appear in the times of the world
	if (options->timings)
		TRY(b->f->timings(b, milliseconds));
	verdict->worlds = test.worlds;
	verdict->equal = !test.difference[0];
	memcpy(verdict->difference, test.difference, sizeof verdict->difference);
	return SCREE_OK;
}

static void log_verdict(const Device* device, const Verdict* verdict)
{
	if (verdict->equal)
		log_sentence(SCREE_LOG_INFO, "%s was tested: %d float results and %d worlds have the bits of the CPU.",
		             device->about.name, verdict->results, verdict->worlds);
	else
		log_sentence(SCREE_LOG_WARNING, "%s was tested, and its bits differ from those of the CPU: %s.",
		             device->about.name, verdict->difference);
}

// Tests a device and stores the verdict. Opens the device into *backend, unless its arithmetic differs and the options
// do not allow this.
static scree_status judge(const BackendOptions* options, OpenDevice* open, Device* device, Backend** backend)
{
	Verdict verdict;
	double begin = processor_milliseconds(), spent;
	device->own_rounding = device_own_rounding(device); // not that of an earlier verdict
	TRY(arithmetic_test(device, device_wait_limit(device, options), &verdict));
	spent = processor_milliseconds() - begin;
	device->own_rounding = verdict.own_rounding;
	if (verdict.equal || options->allow_unequal_bits)
		TRY(open(options, device, backend));
	if (verdict.equal)
	{
		begin = processor_milliseconds();
		TRY(judge_worlds(options, *backend, &verdict));
		spent += processor_milliseconds() - begin;
	}
	if (*backend)
		(*backend)->test_milliseconds = spent;
	verdict_write(device->verdict_key, &verdict);
	device_judge(device, &verdict);
	log_verdict(device, &verdict);
	return SCREE_OK;
}

static void close_backend(Backend** backend)
{
	if (*backend)
		(*backend)->f->close(*backend);
	*backend = NULL;
}

scree_status gate_open(const BackendOptions* options, OpenDevice* open, Backend** backend)
{
	*backend = NULL;
	for (;;)
	{
		Device device;
		TRY(device_choose(options, &device));
		if (device.about.tested || !options->test)
			return open(options, &device, backend);
		scree_status status = judge(options, open, &device, backend);
		if (status == SCREE_OK && (device.about.equal_bits || options->allow_unequal_bits))
			return SCREE_OK;
		close_backend(backend);
		TRY(status);
		// device_choose takes another device now, or refuses this one with its verdict
	}
}

scree_status gate_test(const BackendOptions* options, OpenDevice* open)
{
	BackendOptions any = *options;
	any.allow_unequal_bits = true; // a device that failed before may be tested again
	Device device;
	TRY(device_choose(&any, &device));
	Backend* backend = NULL;
	scree_status status = judge(options, open, &device, &backend);
	close_backend(&backend);
	TRY(status);
	return device.about.equal_bits
	           ? SCREE_OK
	           : fail(SCREE_ERROR_NO_DEVICE, "Device %s is refused: %s.", device.about.name, device.about.reason);
}
