// SPDX-License-Identifier: MIT
// test_bad_scenes.c -- checks that each kind of bad input in scene files is refused with its message.
#include "support/scene_text.h"
#include <string.h>

#define SCRATCH "test_bad_scenes_scratch.json"

#define ATTRIBUTE(text) HEAD "\"attributes\": {\"a\": {" text "}}, \"bodies\": [{\"attribute\": \"a\"}]}"
#define JOINT(text)                                                                                                    \
	HEAD GOOD_ATTRIBUTES "\"bodies\": [{\"name\": \"one\", \"attribute\": \"a\"}, {\"name\": \"ten\", \"attribute\": " \
	                     "\"a\", \"repeat\": "                                                                         \
	                     "{\"index\": \"i\", \"to\": 10}, \"position\": [\"i\", 0]}, {\"name\": \"other\", "           \
	                     "\"attribute\": \"a\", \"churn\": "                                                           \
	                     "{\"replaced\": 1, \"position\": [0, 0]}}], \"joints\": [{" text "}]}"
#define REVOLUTE(text) JOINT("\"type\": \"revolute\", \"a\": null, \"b\": {\"body\": \"one\"}, " text)
#define BODY(text)     HEAD GOOD_ATTRIBUTES "\"bodies\": [{\"attribute\": \"a\"}, {" text "}]}"

typedef struct
{
	const char* text;
	const char* sentence; // text that the message contains
} BadScene;

// Checks that each scene is refused with its message, which begins with the name of the file.
static void assert_refused(const BadScene* cases, size_t count)
{
	for (size_t k = 0; k < count; ++k)
	{
		char sentence[SCENE_SENTENCE] = "";
		Scene* scene = load_text(SCRATCH, cases[k].text, NULL, 0, sentence);
		if (scene || !strstr(sentence, cases[k].sentence) || strncmp(sentence, SCRATCH ": ", strlen(SCRATCH) + 2) != 0)
			fail_msg("%s\nsays \"%s\"\nnot  \"%s\"", cases[k].text, sentence, cases[k].sentence);
	}
}

static void test_bad_syntax(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {"{\"name\": \"x\",\n \"title\": }", "line 2, column 11"},
	    {"{\"name\": \"x\", \"name\": \"y\"}", "duplicate"},
	    {HEAD "\"seed\": NaN}", "line 1, column"},
	    {HEAD "\"seed\": 1e999}", "line 1, column"},
	    {"", "line 1, column 0"},
	    {"[]", "must be an object"},
	    {HEAD "\"bodies\": [", "line 1"},
	    {"{\"name\": \"\\u0000\"}", "line 1, column 17: \\u0000 is not allowed"},
	    {"\xef\xbb\xbf[]", "must be an object"},
	    {"\xef\xbb\xbf", "line 1, column 0"},
	    {"\xef\xbb{}", "line 1, column"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

static void test_bad_keys(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {"{\"title\": \"y\"}", "name: is missing"},
	    {HEAD "\"atributes\": {}}", "unknown key \"atributes\"; known are"},
	    {HEAD "\"attributes\": 5}", "attributes: 5 must be an object"},
	    {HEAD "\"bodies\": []}", "attributes: is missing"},
	    {HEAD GOOD_ATTRIBUTES "\"bodies\": 5}", "bodies: 5 must be a list"},
	    {BODY("\"attribute\": \"a\", \"positon\": [0, 0]"), "bodies[1]: unknown key \"positon\""},
	    {BODY("\"attribute\": \"a\", \"position\": 3"), "bodies[1].position: 3 must be a list of 2 numbers"},
	    {BODY("\"attribute\": \"a\", \"position\": [3]"), "bodies[1].position: [3] must be a list of 2 numbers"},
	    {BODY("\"attribute\": \"a\", \"position\": [3, null]"), "bodies[1].position[1]: null must be a number"},
	    {BODY("\"attribute\": \"a\", \"angle\": true"), "bodies[1].angle: true must be a number"},
	    {BODY("\"attribute\": \"a\", \"type\": \"solid\""),
	     "bodies[1].type: \"solid\" must be one of static, kinematic, dynamic"},
	    {BODY("\"attribute\": \"a\", \"disabled\": 3"), "bodies[1].disabled: 3 must be true or false"},
	    {BODY("\"attribute\": \"a\", \"locks\": [\"z\"]"), "bodies[1].locks[0]: \"z\" must be one of x, y, rotation"},
	    {BODY("\"attribute\": \"a\", \"category\": [64]"), "bodies[1].category[0]: 64 must be at most 63"},
	    {HEAD "\"$schema\": 3}", "$schema: 3 must be a string"},
	    {BODY("\"attribute\": \"a\", \"description\": [1]"), "bodies[1].description: [1] must be a string"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

#define TWO_NAMED(members)                                                                                             \
	HEAD GOOD_ATTRIBUTES                                                                                               \
	    "\"bodies\": [{\"name\": \"one\", \"attribute\": \"a\"}, {\"name\": \"two\", \"attribute\": \"a\"}], " members \
	    "}"

static void test_bad_references(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {BODY("\"position\": [0, 0]"), "bodies[1]: attribute is missing"},
	    {BODY("\"attribute\": \"c\""), "bodies[1].attribute: \"c\" is not among the attributes"},
	    {BODY("\"attribute\": [\"a\", \"b\"]"), "bodies[1]: a list of attributes needs choose"},
	    {BODY("\"attribute\": [\"a\", \"b\"], \"choose\": 2"), "bodies[1].choose: 2 must be at most 1"},
	    {BODY("\"collidables\": {}"), "bodies[1].collidables: {} must be a list"},
	    {BODY("\"attribute\": \"a\", \"angle\": 1, \"rotation\": [1, 0]"), "bodies[1]: both angle and rotation"},
	    {BODY("\"attribute\": \"a\", \"rotation\": [1, 0.5]"),
	     "bodies[1].rotation: [1,0.5] must be the cosine and sine of an angle"},
	    {BODY("\"attribute\": \"a\", \"rotation\": [1, \"0\"]"),
	     "bodies[1].rotation: [1,\"0\"] must be a list of 2 numbers, without expressions"},
	    {BODY("\"attribute\": \"a\", \"user\": -1"), "bodies[1].user: -1 must be a whole number from 0, or 0x"},
	    {BODY("\"attribute\": \"a\", \"user\": \"0x10000000000000000\""),
	     "bodies[1].user: \"0x10000000000000000\" must"},
	    {BODY("\"attribute\": \"a\", \"user\": 1.5"), "bodies[1].user: 1.5 must be a whole number"},
	    {BODY("\"attribute\": \"a\", \"mass\": 3"), "bodies[1].mass: 3 must be an object"},
	    {BODY("\"attribute\": \"a\", \"mass\": {}"), "bodies[1].mass: mass is missing"},
	    {BODY("\"attribute\": \"a\", \"mass\": {\"mass\": 0}"), "bodies[1].mass.mass: 0 must be positive"},
	    {BODY("\"attribute\": \"a\", \"mass\": {\"mass\": 1, \"inertia\": 1e-30}"),
	     "bodies[1].mass.inertia: 1e-30 is too close to 0"},
	    {BODY("\"attribute\": \"a\", \"type\": \"static\", \"mass\": {\"mass\": 1}"),
	     "bodies[1].mass: only a dynamic body has a mass"},
	    {BODY("\"attribute\": \"a\", \"mass\": {\"mass\": 1}, \"churn\": {\"position\": [0, 0], \"replaced\": 1}"),
	     "bodies[1].mass: the bodies are replaced"},
	    {HEAD "\"attributes\": {\"b\": {\"box\": [1, 1], \"center\": [0, 0]}}}",
	     "attributes.b.center: only a circle has it"},
	    {TWO_NAMED("\"exclusions\": 1"), "exclusions: 1 must be a list"},
	    {TWO_NAMED("\"exclusions\": [{\"a\": null, \"b\": {\"body\": \"one\"}}]"),
	     "exclusions[0].a: null must be a body"},
	    {TWO_NAMED("\"exclusions\": [{\"a\": {\"body\": \"one\"}}]"), "exclusions[0].b: is missing"},
	    {TWO_NAMED("\"exclusions\": [{\"a\": {\"body\": \"one\"}, \"b\": {\"body\": \"one\"}}]"),
	     "exclusions: a and b are the same body"},
	    {TWO_NAMED("\"exclusions\": [{\"a\": {\"body\": \"one\"}, \"b\": {\"body\": \"three\"}}]"),
	     "exclusions[0].b.body: \"three\" is not the name"},
	    {BODY("\"collidables\": [{\"attribute\": \"d\"}]"), "bodies[1].collidables[0].attribute: \"d\" is not among"},
	    {BODY("\"attribute\": \"a\", \"churn\": 3"), "bodies[1].churn: 3 must be an object"},
	    {BODY("\"attribute\": \"a\", \"churn\": {\"moved\": 1}"), "bodies[1].churn: position is missing"},
	    {BODY("\"attribute\": \"a\", \"churn\": {\"position\": [0, 0], \"to\": 1}"),
	     "bodies[1].churn: unknown key \"to\""},
	    {BODY("\"attribute\": \"a\", \"churn\": {\"position\": [0, 0], \"moved\": 0.5}"),
	     "bodies[1].churn.moved: 0.5 must be a whole number"},
	    {BODY("\"attribute\": \"a\", \"churn\": {\"position\": [0, 0], \"moved\": -1}"),
	     "bodies[1].churn.moved: -1 must not be negative"},
	    {BODY("\"attribute\": \"a\", \"churn\": {\"position\": [0, 0], \"moved\": 1, \"replaced\": 1}"),
	     "bodies[1].churn: moved and replaced are 2 together, must be at most 1, the number of bodies"},
	    {BODY("\"collidables\": [{\"attribute\": \"a\"}], \"churn\": {\"position\": [0, 0], \"replaced\": 1}"),
	     "bodies[1].churn.replaced: a body that is made anew needs attribute, not collidables"},
	    {BODY("\"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 2}, \"churn\": {\"position\": [\"i\", 0]}"),
	     "bodies[1].churn.position[0]: \"i\": i is no parameter"},
	    {BODY("\"attribute\": \"a\", \"angle\": \"i\""), "bodies[1].angle: \"i\": i is no parameter"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

#define EYE(members)                                                                                     \
	HEAD GOOD_ATTRIBUTES                                                                                 \
	    "\"bodies\": [{\"name\": \"eye\", \"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": " \
	    "3000}}, {\"name\": \"wall\", \"type\": \"static\", \"attribute\": \"a\"}], " members "}"
#define RAYS(text) EYE("\"rays\": [{" text "}]")
#define KEYS(text) EYE("\"keys\": [{" text "}]")

static void test_bad_rays(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {EYE("\"rays\": {}"), "rays: {} must be a list"},
	    {EYE("\"rays\": [3]"), "rays[0]: 3 must be an object"},
	    {RAYS("\"length\": 1"), "rays[0]: count is missing"},
	    {RAYS("\"count\": 1"), "rays[0]: length is missing"},
	    {RAYS("\"count\": 0, \"length\": 1"), "rays[0].count: 0 must be at least 1"},
	    {RAYS("\"count\": 1.5, \"length\": 1"), "rays[0].count: 1.5 must be a whole number"},
	    {RAYS("\"count\": 1, \"length\": 0"), "rays[0].length: 0 must be positive"},
	    {RAYS("\"count\": 1, \"length\": 1e6"), "rays[0].length: 1000000.0 must be at most 100000"},
	    {RAYS("\"count\": 1, \"length\": 1, \"spread\": 7"), "rays[0].spread: 7 must be at most 6.2832"},
	    {RAYS("\"count\": 1, \"length\": 1, \"radius\": -1"), "rays[0].radius: -1 must not be negative"},
	    {RAYS("\"count\": 1, \"length\": 1, \"angle\": \"i\""), "rays[0].angle: \"i\": i is no parameter"},
	    {RAYS("\"count\": 1, \"length\": 1, \"position\": 3"), "rays[0].position: 3 must be a list of 2 numbers"},
	    {RAYS("\"count\": 1, \"length\": 1, \"from\": \"ear\""),
	     "rays[0].from: \"ear\" is not the name of an entry of bodies"},
	    {RAYS("\"count\": 1, \"length\": 1, \"from\": 3"), "rays[0].from: 3 must be a string"},
	    {RAYS("\"count\": 1, \"length\": 1, \"sees\": \"static\""), "rays[0].sees: \"static\" must be a list of"},
	    {RAYS("\"count\": 1, \"length\": 1, \"sees\": [\"all\"]"),
	     "rays[0].sees[0]: \"all\" must be one of static, kinematic,"},
	    {RAYS("\"count\": 1, \"length\": 1, \"mask\": [64]"), "rays[0].mask[0]: 64 must be at most 63"},
	    {RAYS("\"count\": 1, \"length\": 1, \"skip_inside\": 1"), "rays[0].skip_inside: 1 must be true or false"},
	    {RAYS("\"count\": 1, \"length\": 1, \"any\": true"), "rays[0]: unknown key \"any\""},
	    {RAYS("\"count\": 10000, \"length\": 1, \"from\": \"eye\""),
	     "rays[0]: 30000000 rays up to here; a scene has at most 20000000"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

static void test_bad_controls(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {EYE("\"keys\": 3"), "keys: 3 must be a list"},
	    {KEYS("\"body\": \"eye\", \"torque\": 1"), "keys[0].key: is missing"},
	    {KEYS("\"key\": \"q\", \"body\": \"eye\", \"torque\": 1"), "keys[0].key: \"q\" must be one of left, right"},
	    {KEYS("\"key\": \"up\", \"torque\": 1"), "keys[0].body: is missing"},
	    {KEYS("\"key\": \"up\", \"body\": \"ear\", \"torque\": 1"), "keys[0].body: \"ear\" is not the name"},
	    {KEYS("\"key\": \"up\", \"body\": \"wall\", \"torque\": 1"), "keys[0].body: wall is not dynamic"},
	    {KEYS("\"key\": \"up\", \"body\": \"eye\", \"index\": 3000, \"torque\": 1"),
	     "keys[0].index: 3000 must be at most 2999"},
	    {KEYS("\"key\": \"up\", \"body\": \"eye\""), "keys[0]: needs force or torque"},
	    {KEYS("\"key\": \"up\", \"body\": \"eye\", \"force\": 3"), "keys[0].force: 3 must be a list of 2 numbers"},
	    {KEYS("\"key\": \"up\", \"body\": \"eye\", \"torque\": 1, \"turns\": 2"), "keys[0].turns: 2 must be true"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

#define HERO(text)                                                                                                \
	HEAD GOOD_ATTRIBUTES                                                                                          \
	    "\"bodies\": [{\"name\": \"wall\", \"attribute\": \"a\"}, {\"name\": \"none\", \"type\": \"kinematic\", " \
	    "\"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 0}}, {\"name\": \"hero\", \"type\": "       \
	    "\"kinematic\", "                                                                                         \
	    "\"attribute\": \"a\"}], \"characters\": " text "}"

static void test_bad_characters(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {HERO("3"), "characters: 3 must be a list"},
	    {HERO("[{\"speed\": 1}]"), "characters[0].body: is missing"},
	    {HERO("[{\"body\": \"him\"}]"), "characters[0].body: \"him\" is not the name of an entry of bodies"},
	    {HERO("[{\"body\": \"wall\"}]"), "characters[0].body: must be the name of kinematic bodies"},
	    {HERO("[{\"body\": \"none\"}]"), "characters[0].body: has no bodies"},
	    {HERO("[{\"body\": \"hero\", \"takes\": \"gold\"}]"), "characters[0].takes: \"gold\" is not the name"},
	    {HERO("[{\"body\": \"hero\", \"radius\": 0}]"), "characters[0].radius: 0 must be positive"},
	    {HERO("[{\"body\": \"hero\", \"slope\": 2}]"), "characters[0].slope: 2 must be at most 1.57"},
	    {HERO("[{\"body\": \"hero\", \"hat\": 2}]"), "characters[0]"},
	    {HERO("[{\"body\": \"hero\", \"script\": 2}]"), "characters[0].script: 2 must be a list"},
	    {HERO("[{\"body\": \"hero\", \"script\": [{\"step\": 1}]}]"), "characters[0].script[0].hold: must be a list"},
	    {HERO("[{\"body\": \"hero\", \"script\": [{\"step\": 1, \"hold\": [\"x\"]}]}]"),
	     "characters[0].script[0].hold[0]: \"x\" must be one of left"},
	    {HERO("[{\"body\": \"hero\", \"script\": [{\"step\": 5, \"hold\": []}, {\"step\": 5, \"hold\": []}]}]"),
	     "characters[0].script[1].step: 5 must be at least 6"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

static void test_bad_names(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {BODY("\"name\": 3, \"attribute\": \"a\""), "bodies[1].name: 3 must be a string that is not empty"},
	    {BODY("\"name\": \"\", \"attribute\": \"a\""), "bodies[1].name: \"\" must be a string that is not empty"},
	    {BODY("\"name\": \"abcdefghijklmnopqrstuvwxyz_abcdef\", \"attribute\": \"a\""),
	     "bodies[1].name: a name has 1 to 31 characters"},
	    {BODY("\"name\": \"x\", \"attribute\": \"a\"}, {\"name\": \"x\", \"attribute\": \"b\""),
	     "bodies[2].name: \"x\" is the name of bodies above"},
	    {BODY("\"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 3}, \"group\": \"i / 2\""),
	     "bodies[1].group: \"i / 2\" is 0.5, must be a whole number, at i = 1"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

static void test_bad_joints(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {HEAD GOOD_ATTRIBUTES "\"bodies\": [], \"joints\": 5}", "joints: 5 must be a list"},
	    {JOINT("\"type\": \"revolute\", \"anchor\": 1"),
	     "joints[0]: unknown key \"anchor\"; known are type, a, b, at,"},
	    {JOINT("\"a\": null"), "joints[0].type: is missing"},
	    {JOINT("\"type\": \"hinge\""), "joints[0].type: \"hinge\" must be one of free, distance, revolute,"},
	    {JOINT("\"type\": 4"), "joints[0].type: 4 must be one of"},
	    {REVOLUTE("\"at\": 4"), "joints[0].at: 4 must be a list of 2 numbers"},
	    {REVOLUTE("\"at\": [0, 1e6]"), "joints[0].at[1]: 1000000.0 must be at most 100000"},
	    {REVOLUTE("\"axis\": 1"), "joints[0]: at is missing"},
	    {REVOLUTE("\"to\": [0, 0]"), "joints[0]: at is missing"},
	    {REVOLUTE("\"at\": [0, 0], \"frame_b\": {}"), "joints[0]: both at and frame_b"},
	    {REVOLUTE("\"frame_a\": {\"place\": 1}"),
	     "joints[0].frame_a: unknown key \"place\"; known are position, angle"},
	    {REVOLUTE("\"frame_a\": {\"angle\": []}"), "joints[0].frame_a.angle: [] must be a number"},
	    {REVOLUTE("\"hertz\": -1"), "joints[0].hertz: -1 must not be negative"},
	    {REVOLUTE("\"force_threshold\": -1"), "joints[0].force_threshold: -1 must not be negative"},
	    {REVOLUTE("\"can_break\": 1"), "joints[0].can_break: 1 must be true or false"},
	    {REVOLUTE("\"collide_connected\": \"no\""), "joints[0].collide_connected: \"no\" must be true or false"},
	    {REVOLUTE("\"repeat\": {\"index\": \"i\", \"to\": 30000000}"), "joints[0]: 30000000 or more items"},
	    {JOINT("\"type\": \"distance\", \"a\": null, \"b\": {\"body\": \"one\"}, \"at\": [0, 0]"),
	     "joints[0]: a distance joint with at needs to"},
	    {JOINT("\"type\": \"distance\", \"a\": null, \"b\": {\"body\": \"one\"}, \"at\": [-8e4, 0], \"to\": [8e4, 0]"),
	     "joints[0]: along.target: 160000 must be at most 100000"},
	    {HEAD GOOD_ATTRIBUTES
	     "\"bodies\": [{\"name\": \"one\", \"attribute\": \"a\", \"position\": [8e4, 0]}], \"joints\": "
	     "[{\"type\": \"weld\", \"a\": null, \"b\": {\"body\": \"one\"}, \"at\": [-8e4, 0]}]}",
	     "joints[0]: anchor of b in its body: 160000 must be at most 100000"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

#define COUPLING(type, text) \
	JOINT("\"type\": \"" type "\", \"a\": null, \"b\": {\"body\": \"one\"}, \"at\": [0, 0], " text)

static void test_bad_couplings(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {COUPLING("revolute", "\"ratio\": 2"), "joints[0].ratio: only a gear or a pulley has it"},
	    {COUPLING("revolute", "\"side_a\": {}"), "joints[0].side_a: only a gear or a pulley has it"},
	    {COUPLING("distance", "\"to\": [1, 0], \"side_b\": {}"), "joints[0].side_b: only a gear or a pulley has it"},
	    {COUPLING("gear", "\"side_a\": {\"measure\": \"turns\"}"),
	     "joints[0].side_a.measure: \"turns\" must be one of angle, translation, distance"},
	    {COUPLING("gear", "\"side_b\": {\"measure\": 1}"),
	     "joints[0].side_b.measure: 1 must be one of angle, translation, distance"},
	    {COUPLING("gear", "\"side_b\": {\"measure\": null}"),
	     "joints[0].side_b.measure: null must be one of angle, translation, distance"},
	    {COUPLING("pulley", "\"side_a\": 3"), "joints[0].side_a: 3 must be an object"},
	    {COUPLING("pulley", "\"side_a\": {\"base\": [0, 1]}"),
	     "joints[0].side_a: unknown key \"base\"; known are measure, position, angle"},
	    {COUPLING("pulley", "\"side_b\": {\"position\": [0]}"),
	     "joints[0].side_b.position: [0] must be a list of 2 numbers"},
	    {COUPLING("pulley", "\"side_b\": {\"position\": [0, 1e6]}"),
	     "joints[0].side_b.position[1]: 1000000.0 must be at most 100000"},
	    {COUPLING("gear", "\"side_b\": {\"angle\": true}"), "joints[0].side_b.angle: true must be a number"},
	    {COUPLING("pulley", "\"across\": {\"locked\": true}"),
	     "joints[0].across: a gear or a pulley has the coordinate along only"},
	    {COUPLING("gear", "\"angle\": {\"motor\": {\"speed\": 1, \"max\": 1}}"),
	     "joints[0].angle: a gear or a pulley has the coordinate along only"},
	    {COUPLING("gear", "\"ratio\": 2e6"), "joints[0].ratio: 2000000.0 must be at most 1000000"},
	    {COUPLING("gear", "\"ratio\": \"-1e6 * (i + 1)\", \"repeat\": {\"index\": \"i\", \"to\": 3}"),
	     "joints[0].ratio: \"-1e6 * (i + 1)\" is -2000000, must be at least -1000000, at i = 1"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

#define RAIL(path, text)                                                                                          \
	"{\"name\": \"x\", \"title\": \"y\", \"attributes\": {\"ball\": {\"circle\": 1}}, \"paths\": " path           \
	", \"bodies\": [{\"name\": \"one\", \"attribute\": \"ball\"}], \"joints\": [{\"a\": null, \"b\": {\"body\": " \
	"\"one\"}, " text "}]}"
#define GOOD_RAIL "{\"rail\": {\"points\": [[0, 0], [1, 0]]}}"

static void test_bad_paths(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {RAIL("[]", "\"type\": \"path\""), "paths: [] must be an object of paths by name"},
	    {RAIL("{\"rail\": {}}", "\"type\": \"path\""), "paths.rail.points: is missing"},
	    {RAIL("{\"rail\": {\"points\": [[0, 0]]}}", "\"type\": \"path\""),
	     "paths.rail: count is 1, must be from 2 to 65536 for an open path"},
	    {RAIL("{\"rail\": {\"points\": []}}", "\"type\": \"path\""), "paths.rail: count is 0"},
	    {RAIL("{\"rail\": {\"points\": [[0, 0], [1, 0]], \"closed\": true}}", "\"type\": \"path\""),
	     "paths.rail: count is 2, must be from 3 to 65536 for a closed path"},
	    {RAIL("{\"rail\": {\"points\": [[0, 0], [0, 0]]}}", "\"type\": \"path\""),
	     "paths.rail: points[1] is 0 m from the one before it"},
	    {RAIL("{\"rail\": {\"points\": [[0, 0], [0, 1e6]]}}", "\"type\": \"path\""),
	     "paths.rail.points[1][1]: 1000000.0 must be at most 100000"},
	    {RAIL("{\"rail\": {\"points\": [{\"position\": [\"1e5 * k\", 0], \"repeat\": {\"index\": \"k\", \"to\": 3}}]}}",
	          "\"type\": \"path\""),
	     "paths.rail.points[0].position[0]: \"1e5 * k\" is 200000, must be at most 100000, at k = 2"},
	    {RAIL("{\"rail\": {\"points\": [[0, 0], [1, 0]], \"bends\": 1}}", "\"type\": \"path\""),
	     "paths.rail: unknown key \"bends\"; known are points, closed, user, description"},
	    {RAIL("{\"rail\": {\"points\": [{}, [1, 0], [2, 0]]}}", "\"type\": \"path\""),
	     "paths.rail.points[0].position: is missing"},
	    {RAIL("{\"rail\": {\"points\": [[0, 0], {\"position\": [\"k\", 1], \"repeat\": {\"index\": \"k\", \"to\": "
	          "1e5}}]}}",
	          "\"type\": \"path\""),
	     "paths.rail.points[1]: 100000 or more items; the path has room for 65535"},
	    {RAIL(GOOD_RAIL, "\"type\": \"path\""), "joints[0].path: is missing"},
	    {RAIL(GOOD_RAIL, "\"type\": \"path\", \"path\": \"road\""), "joints[0].path: \"road\" is not among the paths"},
	    {RAIL(GOOD_RAIL, "\"type\": \"path\", \"path\": \"rail\", \"initial_along\": 1e6"),
	     "joints[0].initial_along: 1000000.0 must be at most 100000"},
	    {RAIL(GOOD_RAIL, "\"type\": \"path\", \"path\": \"rail\", \"at\": [0, 0], \"to\": [1, 0]"),
	     "joints[0]: to: a path joint has one anchor, that of b"},
	    {RAIL(GOOD_RAIL, "\"type\": \"weld\", \"path\": \"rail\""), "joints[0].path: only a path joint has it"},
	    {RAIL(GOOD_RAIL, "\"type\": \"weld\", \"initial_along\": 1"),
	     "joints[0].initial_along: only a path joint has it"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

#define TWO(a, b) JOINT("\"type\": \"revolute\", \"repeat\": {\"index\": \"i\", \"to\": 10}, \"a\": " a ", \"b\": " b)

static void test_bad_ends(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {JOINT("\"type\": \"revolute\", \"b\": null"), "joints[0].a: is missing"},
	    {TWO("null", "null"), "joints[0]: a and b are both null"},
	    {TWO("null", "\"one\""), "joints[0].b: \"one\" must be an object"},
	    {TWO("null", "{\"index\": 1}"), "joints[0].b.body: is missing"},
	    {TWO("null", "{\"body\": \"two\"}"), "joints[0].b.body: \"two\" is not the name of an entry of bodies"},
	    {TWO("null", "{\"body\": \"ten\"}"), "joints[0].b: index is missing: the number of bodies \"ten\" is 10"},
	    {TWO("null", "{\"body\": \"ten\", \"index\": 10}"), "joints[0].b.index: 10 must be at most 9"},
	    {TWO("null", "{\"body\": \"ten\", \"index\": \"i + 1\"}"),
	     "joints[0].b.index: \"i + 1\" is 10, must be at most 9, at i = 9"},
	    {TWO("null", "{\"body\": \"ten\", \"index\": \"i / 2\"}"),
	     "joints[0].b.index: \"i / 2\" is 0.5, must be a whole number, at i = 1"},
	    {TWO("{\"body\": \"ten\", \"index\": \"4\"}", "{\"body\": \"ten\", \"index\": \"i\"}"),
	     "joints[0]: a and b are the same body, at i = 4"},
	    {TWO("null", "{\"body\": \"other\"}"), "joints[0].b.body: the bodies \"other\" are replaced"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

static void test_bad_coordinates(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {REVOLUTE("\"angle\": 1"), "joints[0].angle: 1 must be an object"},
	    {REVOLUTE("\"angle\": {\"limit\": 1}"),
	     "joints[0].angle: unknown key \"limit\"; known are locked, limits, target"},
	    {REVOLUTE("\"angle\": {\"locked\": 1}"), "joints[0].angle.locked: 1 must be true or false"},
	    {REVOLUTE("\"along\": {\"limits\": [0, 1]}"),
	     "joints[0].along: a locked coordinate has no limits; \"locked\": false frees it"},
	    {REVOLUTE("\"along\": {\"motor\": {}}"), "joints[0].along: a locked coordinate has no motor"},
	    {REVOLUTE("\"angle\": {\"lock\": {}}"), "joints[0].angle: lock is the stiffness of a locked coordinate"},
	    {REVOLUTE("\"angle\": {\"limits\": 1}"), "joints[0].angle.limits: 1 must be a list of 2 numbers"},
	    {REVOLUTE("\"angle\": {\"limits\": [0, \"x\"]}"), "joints[0].angle.limits[1]: \"x\": x is no parameter"},
	    {REVOLUTE("\"angle\": {\"limits\": [\"i\", 3]}, \"repeat\": {\"index\": \"i\", \"to\": 9}"),
	     "joints[0]: angle.limits: 4 is above 3, at i = 4"},
	    {REVOLUTE("\"angle\": {\"spring\": {\"stiffness\": 1}}"),
	     "joints[0].angle.spring: unknown key \"stiffness\"; known are hertz, damping_ratio, max"},
	    {REVOLUTE("\"angle\": {\"spring\": {\"hertz\": -1}}"), "joints[0].angle.spring.hertz: -1 must not be negative"},
	    {REVOLUTE("\"angle\": {\"spring\": {\"damping_ratio\": 1}}"),
	     "joints[0].angle.spring: hertz is missing, and without it a spring does nothing"},
	    {REVOLUTE("\"angle\": {\"motor\": {\"speed\": 1}}"),
	     "joints[0].angle.motor: max is missing, and without it a motor does nothing"},
	    {REVOLUTE("\"angle\": {\"motor\": {\"max\": \"3 - i\"}}, \"repeat\": {\"index\": \"i\", \"to\": 9}"),
	     "joints[0].angle.motor.max: \"3 - i\" is -1, must not be negative, at i = 4"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

static void test_bad_values(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {BODY("\"attribute\": \"a\", \"linear_damping\": -1"), "bodies[1].linear_damping: -1 must not be negative"},
	    {BODY("\"attribute\": \"a\", \"position\": [0, 1e6]"),
	     "bodies[1].position[1]: 1000000.0 must be at most 100000"},
	    {BODY("\"attribute\": \"a\", \"velocity\": [500000, 0]"),
	     "bodies[1].velocity[0]: 500000 must be at most 100000"},
	    {BODY("\"attribute\": \"a\", \"angle\": \"1/0\""), "bodies[1].angle: \"1/0\": division by zero"},
	    {BODY("\"attribute\": \"a\", \"angle\": \"1e300*1e300\""),
	     "bodies[1].angle: \"1e300*1e300\" is inf, must be finite"},
	    {HEAD "\"world\": {\"dt\": 0}, " GOOD_ATTRIBUTES "\"bodies\": []}", "world.dt: 0 must be positive"},
	    {HEAD "\"world\": {\"contact_details\": 1}, " GOOD_ATTRIBUTES "\"bodies\": []}",
	     "world.contact_details: 1 must be true or false"},
	    {HEAD "\"world\": {\"sleep\": \"on\"}, " GOOD_ATTRIBUTES "\"bodies\": []}",
	     "world.sleep: \"on\" must be true or false"},
	    {HEAD "\"world\": {\"sleep_threshold\": 0}, " GOOD_ATTRIBUTES "\"bodies\": []}",
	     "world.sleep_threshold: 0 must be positive"},
	    {HEAD "\"world\": {\"sleep_threshold\": 2e6}, " GOOD_ATTRIBUTES "\"bodies\": []}",
	     "world.sleep_threshold: 2000000.0 must be at most 1000000"},
	    {BODY("\"attribute\": \"a\", \"asleep\": 0"), "bodies[1].asleep: 0 must be true or false"},
	    {BODY("\"attribute\": \"a\", \"stays_awake\": null"), "bodies[1].stays_awake: null must be true or false"},
	    {BODY("\"attribute\": \"a\", \"sleep_threshold\": \"i - 1\", \"repeat\": {\"index\": \"i\", \"to\": 2}"),
	     "bodies[1].sleep_threshold: \"i - 1\" is -1, must not be negative, at i = 0"},
	    {HEAD "\"world\": {\"substeps\": 1.5}, " GOOD_ATTRIBUTES "\"bodies\": []}",
	     "world.substeps: 1.5 must be a whole"},
	    {HEAD "\"view\": [0, 0, 0, 1], " GOOD_ATTRIBUTES "\"bodies\": []}", "view: [0,0,0,1] is empty"},
	    {HEAD "\"view\": [0, 0, 1e-30, 1], " GOOD_ATTRIBUTES "\"bodies\": []}",
	     "view: [0,0,1e-30,1] is narrower or lower than 0.01 m"},
	    {HEAD "\"view\": [99999.9999, 0, 1e5, 1], " GOOD_ATTRIBUTES "\"bodies\": []}", "narrower or lower than 0.01 m"},
	    {HEAD "\"view\": [0, 0, 1, 1], \"detail\": [0, 0, 1], " GOOD_ATTRIBUTES "\"bodies\": []}",
	     "detail: [0,0,1] must be a list of 4 numbers"},
	    {HEAD "\"detail\": [0, 0, 1, 1], " GOOD_ATTRIBUTES "\"bodies\": []}",
	     "detail: needs a view, which it is a part of"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

static void test_bad_attributes(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {ATTRIBUTE("\"circle\": -1"), "attributes.a.circle: -1 must be positive"},
	    {ATTRIBUTE("\"circle\": 0.0001"), "attributes.a.circle: 0.0001 must be at least 0.001"},
	    {ATTRIBUTE("\"box\": [1, 0]"), "attributes.a.box[1]: 0 must be positive"},
	    {ATTRIBUTE("\"circle\": 1, \"density\": -1"), "attributes.a.density: -1 must not be negative"},
	    {ATTRIBUTE("\"circle\": 1, \"restitution\": 200"), "attributes.a.restitution: 200 must be at most 100"},
	    {ATTRIBUTE("\"circle\": 1, \"density\": 1e-7"), "attributes.a.density: 1e-7 is too close to 0"},
	    {ATTRIBUTE("\"circle\": 1, \"one_way\": [0, 1e-4]"), "attributes.a.one_way: [0,0.0001] is too close to 0"},
	    {ATTRIBUTE("\"density\": 1"), "attributes.a: no shape"},
	    {ATTRIBUTE("\"circle\": 1, \"box\": [1, 1]"), "attributes.a: both box and circle"},
	    {ATTRIBUTE("\"capsule\": [[0, 0], [1, 0]]"), "attributes.a: a capsule needs a radius"},
	    {ATTRIBUTE("\"segment\": [[0, 0]]"), "attributes.a.segment: count is 1, must be 2"},
	    {ATTRIBUTE("\"polygon\": [[0, 0], [1, 0]]"), "attributes.a.polygon: count is 2, must be 3 to 8"},
	    {ATTRIBUTE("\"polygon\": [[0,0],[1,0],[2,1],[3,3],[2,4],[1,5],[0,5],[-1,4],[-1,1]]"),
	     "attributes.a.polygon: count is 9, must be 3 to 8"},
	    {ATTRIBUTE("\"polygon\": [[0, 0], [1, 0], [2, 0]]"), "attributes.a.polygon: "},
	    {ATTRIBUTE("\"polygon\": [[0, 0], [2, 0], [1, 0.2], [1, 2]]"), "attributes.a.polygon: "},
	    {ATTRIBUTE("\"polygon\": [[0, 0], [1, \"x\"], [2, 0]]"),
	     "attributes.a.polygon[1][1]: \"x\": x is no parameter"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

static void test_bad_parameters(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {HEAD "\"parameters\": {\"n\": {}}}", "parameters.n: default is missing"},
	    {HEAD "\"parameters\": {\"N\": {\"default\": 1}}}", "parameters.N: the name is taken, or is not"},
	    {HEAD "\"parameters\": {\"sin\": {\"default\": 1}}}", "parameters.sin: the name is taken"},
	    {HEAD "\"parameters\": {\"n\": {\"default\": 0, \"min\": 1}}}", "parameters.n.default: 0 must be at least 1"},
	    {HEAD "\"constants\": {\"n\": \"m + 1\"}}", "constants.n: \"m + 1\": m is no parameter"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

static void test_bad_loops(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {BODY("\"attribute\": \"a\", \"repeat\": {\"index\": \"i\"}"), "bodies[1].repeat: to is missing"},
	    {BODY("\"attribute\": \"a\", \"repeat\": {\"to\": 3}"), "bodies[1].repeat.index: is missing"},
	    {BODY("\"attribute\": \"a\", \"repeat\": {\"index\": \"pi\", \"to\": 3}"),
	     "bodies[1].repeat.index: \"pi\" is taken"},
	    {BODY("\"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 1.5}"),
	     "bodies[1].repeat.to: 1.5 must be a whole"},
	    {BODY("\"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 30000000}"),
	     "bodies[1]: 30000000 or more items; the scene has room for 16777215"},
	    {BODY("\"attribute\": \"a\", \"repeat\": []"), "bodies[1].repeat: 0 nested ranges, must be 1 to 4"},
	    {BODY("\"collidables\": [{\"attribute\": \"a\", \"repeat\": {\"index\": \"k\", \"to\": 60000}}], \"repeat\": "
	          "{\"index\": \"i\", \"to\": 500}"),
	     "bodies[1]: 30000001 collidables up to here; a scene has at most 16777216"},
	    {BODY("\"attribute\": \"a\", \"repeat\": [{\"index\": \"i\", \"to\": 1e9}, {\"index\": \"j\", \"to\": 0}]"),
	     "bodies[1]: more than 50000000 rounds of nested ranges"},
	    {BODY("\"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 9}, \"position\": [0, \"1 / (i - 4)\"]"),
	     "bodies[1].position[1]: \"1 / (i - 4)\": division by zero, at i = 4"},
	    {BODY("\"attribute\": \"a\", \"repeat\": {\"index\": \"i\", \"to\": 9}, \"linear_damping\": \"3 - i\""),
	     "bodies[1].linear_damping: \"3 - i\" is -1, must not be negative, at i = 4"},
	    {BODY("\"collidables\": [{\"attribute\": \"a\", \"repeat\": {\"index\": \"k\", \"to\": -1}}]"),
	     "bodies[1].collidables[0].repeat: must give the same"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

#define FIELD(text) \
	HEAD GOOD_ATTRIBUTES "\"bodies\": [{\"name\": \"one\", \"attribute\": \"a\"}], \"fields\": [{" text "}]}"
#define BLAST(text) HEAD GOOD_ATTRIBUTES "\"bodies\": [{\"attribute\": \"a\"}], \"blasts\": [{" text "}]}"

static void test_bad_fields(void** state)
{
	(void)state;
	const BadScene cases[] = {
	    {HEAD GOOD_ATTRIBUTES "\"bodies\": [{\"attribute\": \"a\"}], \"fields\": {}}",
	     "fields: {} must be a list, [ ... ]"},
	    {FIELD(""), "fields[0].type: is missing, must be one of uniform, radial, vortex, drag, wind, buoyancy"},
	    {FIELD("\"type\": \"water\""), "fields[0].type: \"water\" must be one of uniform, radial,"},
	    {FIELD("\"type\": \"radial\", \"falloff\": 2"),
	     "fields[0].falloff: 2 must be one of constant, linear, inverse,"},
	    {FIELD("\"type\": \"drag\", \"attribute\": \"c\""), "fields[0].attribute: \"c\" is not among the attributes"},
	    {FIELD("\"type\": \"buoyancy\", \"attribute\": \"a\""),
	     "fields[0].attribute: a fluid needs a box or a polygon without rounding, and \"a\" is none"},
	    {FIELD("\"type\": \"drag\", \"body\": {\"body\": \"two\"}"), "fields[0].body.body: \"two\" is not the name"},
	    {FIELD("\"type\": \"drag\", \"drag\": -1"), "fields[0].drag: -1 must"},
	    {FIELD("\"type\": \"drag\", \"velocity\": [1]"), "fields[0].velocity: [1] must be a list of 2 numbers"},
	    {FIELD("\"type\": \"drag\", \"wet\": 1"), "fields[0]"},
	    {FIELD("\"type\": \"radial\", \"radius\": \"i\", \"repeat\": {\"index\": \"i\", \"to\": 3}"),
	     "fields[0].radius"},
	    {BLAST("\"position\": [0, 0]"), "blasts[0]: step is missing"},
	    {BLAST("\"step\": -1"), "blasts[0].step: -1 must"},
	    {BLAST("\"step\": 1.5"), "blasts[0].step: 1.5 must"},
	    {BLAST("\"step\": 1, \"radius\": -1"), "blasts[0].radius: -1 must"},
	};
	assert_refused(cases, sizeof cases / sizeof cases[0]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_bad_syntax),     cmocka_unit_test(test_bad_keys),
	    cmocka_unit_test(test_bad_characters), cmocka_unit_test(test_bad_references),
	    cmocka_unit_test(test_bad_names),      cmocka_unit_test(test_bad_rays),
	    cmocka_unit_test(test_bad_controls),   cmocka_unit_test(test_bad_joints),
	    cmocka_unit_test(test_bad_ends),       cmocka_unit_test(test_bad_coordinates),
	    cmocka_unit_test(test_bad_values),     cmocka_unit_test(test_bad_attributes),
	    cmocka_unit_test(test_bad_parameters), cmocka_unit_test(test_bad_loops),
	    cmocka_unit_test(test_bad_couplings),  cmocka_unit_test(test_bad_paths),
	    cmocka_unit_test(test_bad_fields),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
