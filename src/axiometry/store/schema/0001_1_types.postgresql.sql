-- SPDX-License-Identifier: Apache-2.0
-- What the common files take for granted. plain_text is ordered by its bytes, as in SQLite, whatever the server's locale.
CREATE DOMAIN plain_text AS text COLLATE "C";
CREATE DOMAIN blob AS bytea;
CREATE FUNCTION instr(text, text) RETURNS integer LANGUAGE sql IMMUTABLE PARALLEL SAFE AS 'SELECT strpos($1, $2)';
