// SPDX-License-Identifier: Apache-2.0
import { defineConfig } from 'vite';

// The bundle is kept in the repository, so that the program is built without node: the same sources must give the same
// bytes. Plain names: the program serves it with a hash of its content as the validator.
export default defineConfig({
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
      output: { entryFileNames: 'app.js', assetFileNames: 'app[extname]', inlineDynamicImports: true },
    },
  },
  // While the page is worked on: `npx vite` beside a program that serves the API.
  server: { host: '127.0.0.1', proxy: { '/api': process.env['AXIOMETRY_SERVER'] ?? 'http://127.0.0.1:8230' } },
});
