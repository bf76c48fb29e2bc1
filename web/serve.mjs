// SPDX-License-Identifier: MIT
// serve.mjs -- serve.mjs FOLDER [PORT] [plain]: serves a folder on this machine over HTTP, with the headers that a page
// needs for threads.
//
// `plain` omits these headers, as most static hosts do.
import { createServer } from 'node:http';
import { createReadStream, statSync } from 'node:fs';
import { extname, join, normalize } from 'node:path';

const TYPES = {
	'.html': 'text/html; charset=utf-8',
	'.css': 'text/css; charset=utf-8',
	'.js': 'text/javascript; charset=utf-8',
	'.mjs': 'text/javascript; charset=utf-8',
	'.json': 'application/json',
	'.wasm': 'application/wasm',
	'.png': 'image/png',
	'.svg': 'image/svg+xml',
};
const ISOLATION = { 'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp' };

const [folder = 'build/web', port = '8080', plain] = process.argv.slice(2);

function answer(request, response) {
	let path = join(folder, normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname)));
	try {
		if (statSync(path).isDirectory()) path = join(path, 'index.html');
		const { size } = statSync(path);
		const type = TYPES[extname(path)] ?? 'application/octet-stream';
		const headers = { 'Content-Type': type, 'Content-Length': size, 'Cache-Control': 'no-cache' };
		response.writeHead(200, plain ? headers : { ...headers, ...ISOLATION });
		createReadStream(path).pipe(response);
	} catch {
		response.writeHead(404, { 'Content-Type': 'text/plain' });
		response.end('there is no such file\n');
	}
}

const server = createServer(answer);
server.on('error', (error) => {
	console.error(`serve.mjs: cannot listen on port ${port}: ${error.message}`);
	process.exit(1);
});
server.listen(Number(port), '127.0.0.1', () => {
	console.log(`http://127.0.0.1:${server.address().port}/`);
});
