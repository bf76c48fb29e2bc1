// SPDX-License-Identifier: MIT
// link.js -- reads and writes the part of the address after #: scene, parameters, actions of the visitor, and the hash
// after the actions.
//
// #pile?count=500&do=...&at=321&hash=0123456789abcdef, or for a wall #walker?worlds=64
import { decodeActions, encodeActions } from './record.js';

export const LONGEST = 16000; // characters: maximum; some programs that transmit addresses cut off longer ones
const RESERVED = ['do', 'at', 'hash', 'worlds'];
const MOST_WORLDS = 64; // maximum number of worlds of a wall

export function writeLink({ name, settings, worlds, record }) {
	const query = new URLSearchParams(settings);
	if (worlds) query.set('worlds', worlds);
	if (record && record.actions.length > 0) {
		query.set('do', encodeActions(record.actions));
		query.set('at', record.step);
		query.set('hash', record.hash);
	}
	const text = query.toString();
	return `#${name}${text ? `?${text}` : ''}`;
}

// Returns {name, settings, script, until, worlds} for this part of an address. Throws an error with a sentence if the part is
// invalid.
export function readLink(fragment) {
	const [name, query = ''] = fragment.replace(/^#/, '').split('?');
	const values = new URLSearchParams(query);
	const settings = [...values].filter(([key]) => !RESERVED.includes(key));
	const until = { step: Number(values.get('at')), hash: values.get('hash') ?? '' };
	const worlds = Number(values.get('worlds') ?? 0);
	if (!Number.isInteger(worlds) || worlds < 0 || worlds > MOST_WORLDS) throw new Error(`worlds is ${values.get('worlds')}, must be from 0 to ${MOST_WORLDS}`);
	if (!values.has('do') || worlds) return { name: decodeURIComponent(name), settings, script: [], until: null, worlds };
	if (!Number.isSafeInteger(until.step) || until.step < 0 || !/^[0-9a-f]{16}$/.test(until.hash))
		throw new Error('the link is damaged: it has no valid step and hash of its recording');
	return { name: decodeURIComponent(name), settings, script: decodeActions(values.get('do')), until, worlds };
}
