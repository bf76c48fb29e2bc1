// SPDX-License-Identifier: MIT
// worker.js -- runs the engine in a worker.
import { Engine } from './engine.js';

const engine = new Engine((message) => postMessage(message));
let turn = Promise.resolve(); // the engine handles one message after the other
addEventListener('message', ({ data }) => {
	turn = turn.then(() => engine.hear(data));
});
