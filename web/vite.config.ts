// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { defineConfig, type Plugin } from 'vite';

/** The licences of what is bundled, beside the bundle: they ask for it. */
function licences(packages: readonly string[]): Plugin {
  return {
    name: 'licences',
    generateBundle() {
      const source = packages.map((name) => {
        const folder = new URL(`node_modules/${name}/`, import.meta.url);
        const { version, license } = JSON.parse(readFileSync(new URL('package.json', folder), 'utf8')) as { version: string; license: string };
        return `${name} ${version} (${license})\n\n${readFileSync(new URL('LICENSE', folder), 'utf8').trim()}\n`;
      });
      this.emitFile({ type: 'asset', fileName: 'licenses.txt', source: source.join(`\n${'-'.repeat(80)}\n\n`) });
    },
  };
}

// The bundle is kept in the repository, so that the program is built without node: the same sources must give the same
// bytes. What is asked for first has plain names, and the program serves it with a hash of its content as the validator;
// what comes later is named by its content, so that a page never goes on with parts of another program.
export default defineConfig({
  plugins: [licences(['@preact/signals', '@preact/signals-core', 'preact', 'uplot'])],
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact', legalComments: 'none' },
  build: {
    outDir: 'bundle',
    emptyOutDir: true,
    assetsDir: '',
    target: 'es2021',
    modulePreload: false,
    cssCodeSplit: false,
    assetsInlineLimit: 0,
    reportCompressedSize: false,
    rollupOptions: {
      output: {
        entryFileNames: 'app.js', chunkFileNames: '[name]-[hash].js', assetFileNames: 'app[extname]',
        // Little that several pages share comes with one of them.
        experimentalMinChunkSize: 60_000,
      },
    },
  },
  // While the page is worked on: `npx vite` beside a program that serves the API.
  server: { host: '127.0.0.1', proxy: { '/api': process.env['AXIOMETRY_SERVER'] ?? 'http://127.0.0.1:8230' } },
});
