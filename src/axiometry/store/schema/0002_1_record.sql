-- The uncertainty of record of a figure: the interval that was stated, and by which method. Empty of versions from before.
ALTER TABLE figure ADD COLUMN low double precision;
ALTER TABLE figure ADD COLUMN high double precision;
ALTER TABLE figure ADD COLUMN method plain_text NOT NULL DEFAULT '';
