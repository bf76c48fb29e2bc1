// SPDX-License-Identifier: MIT
// link.js -- reads and writes the part of the address after #: scene, parameters, actions of the visitor, and the hash
// after the actions.
//
// #pile?count=500&do=...&at=321&hash=0123456789abcdef
import { decodeActions, encodeActions } from './record.js';

export const LONGEST = 16000; // characters: maximum; some programs that transmit addresses cut off longer ones
const RESERVED = ['do', 'at', 'hash'];

export function writeLink({ name, settings, record }) {
	const query = new URLSearchParams(settings);
	if (record && record.actions.length > 0) {
		query.set('do', encodeActions(record.actions));
		query.set('at', record.step);
		query.set('hash', record.hash);
	}
	const text = query.toString();
	return `#${name}${text ? `?${text}` : ''}`;
}

// Returns {name, settings, script, until} for this part of an address. Throws an error with a sentence if the part is
// invalid.
export function readLink(fragment) {
	const [name, query = ''] = fragment.replace(/^#/, '').split('?');
	const values = new URLSearchParams(query);
	const settings = [...values].filter(([key]) => !RESERVED.includes(key));
	const until = { step: Number(values.get('at')), hash: values.get('hash') ?? '' };
	if (!values.has('do')) return { name: decodeURIComponent(name), settings, script: [], until: null };
	if (!Number.isSafeInteger(until.step) || until.step < 0 || !/^[0-9a-f]{16}$/.test(until.hash))
		throw new Error('the link is damaged: it has no valid step and hash of its recording');
	return { name: decodeURIComponent(name), settings, script: decodeActions(values.get('do')), until };
}
