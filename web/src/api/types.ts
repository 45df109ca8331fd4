// SPDX-License-Identifier: Apache-2.0
// Made of apps/server/openapi.json by api_types.mjs, which "npm run build" runs. What is to change changes there.

export interface components {
    schemas: {
        AnnexABudget: {
            contributors: {
                key: string;
                symbol: string;
                title: string;
                formula: string;
                inputs: {
                    symbol: string;
                    value: number;
                    unit: string;
                    note?: string;
                }[];
                /** @description null where it is not known. */
                U: number | null;
            }[];
            notes: string[];
            runs: number;
            /** @description The environment is stated as drift or random walk. */
            slow_environment: boolean;
            /** @description Contributors that nothing was given of: every U is too small. */
            missing: string[];
            /** @description Where the mean deviations count from, mm or °. */
            datum: number;
            /** @description Composed of the contributors; Annex A states no U of mean deviations. */
            positions: {
                target: number;
                /** @description From the datum; null of rotary axes. */
                length_m: number | null;
                /** @description U of each contributor over that length, by its key; all but eve. */
                contributions: {
                    [key: string]: number | null;
                };
                up: components["schemas"]["AnnexAMean"] | null;
                down: components["schemas"]["AnnexAMean"] | null;
                mean: components["schemas"]["AnnexAMean"] | null;
            }[];
            coverage_factor: number;
            corrected_repeatability?: {
                R: number | null;
                R_up: number | null;
                R_down: number | null;
                floored_targets: number[];
            };
        };
        AnnexAMean: {
            /** @description U_EVE of this mean; null without E_VE. */
            environment: number | null;
            /** @description k = 2. */
            U: number;
        };
        AppliedCorrection: {
            id: string;
            title: string;
            smallest: number;
            largest: number;
            details: {
                name: string;
                value: string;
            }[];
        };
        Approach: {
            /** @description i, counted from 1. */
            target: number;
            /** @description j, counted from 1. */
            run: number;
            direction: components["schemas"]["Direction"];
            /** @description P_i, where the plan has it. */
            position?: number;
        };
        /** @description The first rows of a table of unknown make, and what is known and asked of its columns. */
        AskedTable: {
            profile: components["schemas"]["ImportProfile"];
            questions: {
                /** @description Member of the profile that answers it. */
                key: string;
                text: string;
            }[];
            /** @description Of the columns; empty without a header. */
            names: string[];
            rows: string[][];
        };
        AuditEntry: {
            id: components["schemas"]["Id"];
            change: components["schemas"]["Change"];
            action: string;
            subject: string;
            /** @description What the line records beside these; its members follow the action. */
            detail: {
                [key: string]: unknown;
            };
            /** @description Of this line and the one before: none can be changed or taken away unseen. */
            sha256: components["schemas"]["Sha256"];
        };
        AuditTrail: {
            entries: components["schemas"]["AuditEntry"][];
        };
        Axis: {
            machine: components["schemas"]["Id"];
            name: string;
            kind: components["schemas"]["AxisKind"];
            limits: components["schemas"]["Limit"][];
            notes: string;
        } & components["schemas"]["Entity"];
        AxisEdit: {
            machine: components["schemas"]["Id"];
            name: string;
            kind: components["schemas"]["AxisKind"];
            limits?: components["schemas"]["Limit"][];
            notes?: string;
        } & (components["schemas"]["EditNote"] & components["schemas"]["SentBack"]);
        /** @enum {string} */
        AxisKind: "linear" | "rotary";
        AxisList: {
            axes: components["schemas"]["Axis"][];
        };
        AxisVersions: {
            versions: components["schemas"]["Axis"][];
        };
        Calibration: {
            /** @description Of the test equipment, by its place in the list from 1. */
            component: number;
            instrument: components["schemas"]["Id"];
            version: number;
            certificate: string;
            calibrated_on: string;
            calibration_due: string;
        };
        CalibrationComparison: {
            before: components["schemas"]["CalibrationHead"];
            after: components["schemas"]["CalibrationHead"];
            rows: {
                parameter: string;
                /** @description A line, or a tool; empty: of the whole. */
                of: string;
                unit: string;
                before: number | null;
                before_u: number | null;
                after: number | null;
                after_u: number | null;
                difference: number | null;
            }[];
        };
        CalibrationFigure: {
            /** @description A, E, R, B of a line; `volume_largest`, `volume_percent_95`, `volume_mean` of a tool, without rigid motion; `chi2_per_dof`, `rank`, `unknowns`, `unseen_errors`, `readings`. */
            parameter: string;
            /** @description A line, or a tool; empty: of the whole. */
            of: string;
            value: number;
            /** @description Standard uncertainty. */
            u: number | null;
            /** @enum {string} */
            unit: "um" | "arcsec" | "urad" | "";
        };
        CalibrationForm: {
            kind: components["schemas"]["CalibrationKind"];
            /** @description JSON: title, machine, instrument, measured_on, notes; all may be left out. */
            about?: string;
            /** @description JSON: KeptOptions. */
            options?: string;
            /**
             * Format: binary
             * @description Of straightness, angles and squareness, as in MotionForm, with readings-2 and so on.
             */
            readings?: string;
            /** Format: binary */
            lengths?: string;
            /**
             * Format: binary
             * @description Of the 21 errors, a second file of lengths; further ones are lengths-3 and so on.
             */
            "lengths-2"?: string;
            /**
             * Format: binary
             * @description Of lines; of the 21 errors the plan that was driven, which recordings need; of straightness, angles and squareness as in MotionForm.
             */
            plan?: string;
            /**
             * Format: binary
             * @description Of squareness, as in MotionForm.
             */
            "plan-2"?: string;
            /**
             * Format: binary
             * @description Of lines, as it was located.
             */
            station?: string;
            /**
             * Format: binary
             * @description Of lines, limits by travel as CSV.
             */
            tolerances?: string;
            /**
             * Format: binary
             * @description Of the 21 errors: the machine, its tools and the instrument; those of the plan without it.
             */
            machine?: string;
        };
        CalibrationHead: {
            id: components["schemas"]["Id"];
            version: number;
            kind: components["schemas"]["CalibrationKind"];
            title: string;
            machine: {
                id: components["schemas"]["Id"];
                name: string;
            } | null;
            measured_on: string;
            withdrawn: boolean;
            verdict: components["schemas"]["Verdict"] | null;
            /** @description Findings after which the result should not be used as it is. */
            serious: number;
            figures: components["schemas"]["CalibrationFigure"][];
        };
        /** @enum {string} */
        CalibrationKind: "lines" | "volumetric" | "straightness" | "angles" | "squareness";
        CalibrationPage: {
            calibrations: components["schemas"]["CalibrationRow"][];
            total: number;
        };
        CalibrationRevision: {
            /** @description The version that was looked at. */
            base_version: number;
            reason?: string;
            options?: components["schemas"]["KeptOptions"];
            title?: string;
            machine?: components["schemas"]["Id"] | null;
            instrument?: components["schemas"]["Id"] | null;
            /** @description `2026-01-31`, or empty. */
            measured_on?: string;
            notes?: string;
        };
        CalibrationRow: {
            id: components["schemas"]["Id"];
            version: number;
            kind: components["schemas"]["CalibrationKind"];
            title: string;
            machine: {
                id: components["schemas"]["Id"];
                name: string;
            } | null;
            measured_on: string;
            withdrawn: boolean;
            verdict: components["schemas"]["Verdict"] | null;
            /** @description Findings after which the result should not be used as it is. */
            serious: number;
            figures: components["schemas"]["CalibrationFigure"][];
            /** Format: date-time */
            received_at: string;
        };
        Capture: {
            id: components["schemas"]["Id"];
            /** @description Null of lengths. */
            plan: components["schemas"]["Id"] | null;
            /** @description From 1; 0 for all lines of a plan of lines. */
            part: number;
            source: components["schemas"]["Source"];
            started: string;
            /** @description Grows with every change. */
            revision: number;
            /**
             * @description An interrupted one may be resumed.
             * @enum {string}
             */
            state: "waiting" | "running" | "complete" | "stopped" | "failed" | "interrupted";
            kind: components["schemas"]["AxisKind"];
            /**
             * @description Of the readings. Of a rotation urad until its stream has told otherwise.
             * @enum {string}
             */
            unit: "um" | "arcsec" | "urad";
            /** @description P_i of the plan, or of its part, that is captured. */
            targets: number[];
            /** @description Of the plan. */
            approaches: number;
            due: components["schemas"]["Approach"] | null;
            /** @description Where the axis is; of a straightness or a rotation that of the simulator alone. */
            now: {
                position: number;
                at_rest: boolean;
            } | null;
            /** @description How many readings there are. */
            taken: number;
            /** @description The readings are all there are: forget those of before. */
            anew: boolean;
            readings: components["schemas"]["CapturedReading"][];
            events: {
                /** @enum {string} */
                kind: "zero" | "off zero" | "missed" | "repeated" | "wrong direction" | "too short" | "signal lost" | "unexpected" | "not seen" | "restarted" | "incomplete" | "unsteady" | "doubtful" | "skipped" | "taken back";
                message: string;
                time_s: number;
            }[];
            notices: string[];
            /** @description As soon as a test can be made of it. */
            so_far: components["schemas"]["Evaluated"] | null;
            /** @description Kept as this test when it has ended with readings. */
            test: components["schemas"]["Id"] | null;
            /** @description Of a capture of lengths, in place of targets, readings and test. */
            lengths: components["schemas"]["CapturedLengths"] | null;
            /** @description Of a capture of a straightness or a rotation, beside targets and readings. */
            motion: components["schemas"]["CapturedMotion"] | null;
            error: string | null;
        };
        CaptureIds: {
            captures: components["schemas"]["Id"][];
        };
        CaptureList: {
            captures: components["schemas"]["Capture"][];
        };
        CaptureRequest: {
            plan: components["schemas"]["Id"];
            /** @description Its id. */
            source: string;
            /** @description Of the stream; recognised by itself when empty or left out. */
            layout?: string;
            /** @description By the names of the flags of `axiometry capture`; of the simulator `speed`, `preset` and `seed`. With `stops`, which a plan of a straightness or a rotation needs, it becomes a table of readings; the simulator then also takes `size`, of the bow in µm or µrad (5), sends the readings in the first column beside the time and the trigger or the position in the second, and with `keys` stands at each stop until its reading is taken or skipped. */
            options?: {
                [key: string]: string | number | boolean;
            };
        } | {
            lengths: components["schemas"]["LengthSubject"];
            /** @description Its id. */
            source: string;
            /** @description Of the stream; recognised by itself when empty or left out. */
            layout?: string;
            /** @description By the names of the flags of `axiometry capture`; of the simulator `speed`, `preset` and `seed`. */
            options?: {
                [key: string]: string | number | boolean;
            };
        } | {
            /** @description Number of an interrupted capture that is gone on with. */
            resume: components["schemas"]["Id"];
        };
        CapturedLengths: {
            kind: components["schemas"]["LengthPlanKind"];
            /** @description The same for all captures of one plan, also where that was made again on another day. */
            plan_id: string;
            /** @description Of the part. */
            title: string;
            /** @description The stop that comes next, from 1. */
            due: number | null;
            /** @description As far as is known: a later standstill may show that one belongs elsewhere. Null where nothing changed after the revision that was named, and in lists. */
            caught: {
                stop: number;
                /** @description As shown, mean over the rest. */
                length_mm: number;
                /** @description Standard deviation of its samples. */
                scatter_um: number;
                /** @description Of the recording, when the reflector came to rest. */
                time_s: number;
                /** @description With another dead path than the one before. */
                begins_segment: boolean;
            }[] | null;
            /** @description Stops before which the beam was broken though the plan keeps it. */
            broken_before: number[];
            end: components["schemas"]["CapturedTable"] | null;
        };
        CapturedMotion: {
            /**
             * @description What is read.
             * @example EYX
             */
            error: string;
            stops: components["schemas"]["StopSign"];
            /** @description The last that the instrument sent, in the unit of the capture. */
            now: number | null;
            /** @description Within the window behind a key or a trigger. */
            is_reading: boolean;
            /** @description A reading came so late that somebody must say whose it is: `take` when it is that of the target that is due, `skip` when that one is missing. */
            waits_for_key: boolean;
            end: components["schemas"]["CapturedTable"] | null;
        };
        CapturedPlan: {
            kind: components["schemas"]["LengthPlanKind"];
            plan: components["schemas"]["LengthPlan"];
            plan_id: string;
            part: number;
            parts: components["schemas"]["LengthPart"][];
            /** @description Of the part, in the order in which they come. */
            stops: {
                /** @description The line, or the part. */
                group: string;
                name: string;
                reflector_mm: components["schemas"]["Place"];
                /** @description The plan expects that the beam is lost on the way there. */
                begins_segment: boolean;
            }[];
        };
        CapturedReading: {
            /** @description Of an error motion what was read, as the instrument counts it. */
            deviation: number;
            /** @description In the unit of the deviation; of a single sample, which tells none, 0. */
            spread: number;
            samples: number;
            remarks: string[];
        } & components["schemas"]["Approach"];
        /** @description What a capture of lengths or of an error motion has come to; its files are in the archive. */
        CapturedTable: {
            /** @description Lengths or readings in the table. */
            found: number;
            /** @description What could not be matched or used, where the beam was broken. */
            notes: string[];
            files: ("raw" | "times" | "keys" | "lengths" | "readings")[];
        };
        /** @description Who changed something, when and why. */
        Change: {
            /** Format: date-time */
            at: string;
            actor: string;
            reason: string;
        };
        /**
         * @description Metadata over what the file says: key and text as `--set` takes them; an empty text takes the value away.
         * @example {
         *       "machine.name": "VMC 850",
         *       "tolerance.A": "10"
         *     }
         */
        Changes: {
            [key: string]: string;
        };
        /** @description What may be said of a result with the name of the standard. */
        Claim: {
            /** @enum {string} */
            key: "computed" | "tested" | "reported";
            title: string;
            holds: boolean;
            /** @description Of tested: what it rests on that no item of a test states. */
            remark?: string;
            /** @description What speaks against it: a departure contradicts it, what is missing was not stated. */
            missing: components["schemas"]["Finding"][];
        };
        Counts: {
            machines: number;
            axes: number;
            instruments: number;
            plans: number;
            tests: number;
            documents: number;
            content_bytes: number;
        };
        /** @enum {string} */
        Cycle: "standard" | "step" | "pilgrim" | "unidirectional" | "user-defined";
        /**
         * @description Of approach: towards larger positions, or smaller ones.
         * @enum {string}
         */
        Direction: "up" | "down";
        /** @description A report as it was issued, or an attachment; its bytes never change. */
        Document: {
            id: components["schemas"]["Id"];
            test: components["schemas"]["Id"];
            /** @description Of the test. */
            version: number;
            /** @enum {string} */
            kind: "report" | "attachment";
            name: string;
            media_type: string;
            /** @description Of a report; else empty. */
            language: string;
            sha256: components["schemas"]["Sha256"];
            size: number;
            change: components["schemas"]["Change"];
        };
        Draft: {
            changes?: components["schemas"]["Changes"];
            options?: components["schemas"]["GivenOptions"];
        };
        /** @description Per hour where the course of the test is known in time, else per reading. */
        Drift: {
            per_hour?: number;
            per_reading?: number;
            standard_uncertainty: number | null;
            over_test: number;
            degrees_of_freedom: number;
            basis: string;
        };
        /** @description What goes with a change. */
        EditNote: {
            /** @description Of a change: the version that was looked at. */
            base_version?: number;
            reason?: string;
        };
        /** @description What is kept by versions. */
        Entity: {
            id: components["schemas"]["Id"];
            version: number;
            change: components["schemas"]["Change"];
        };
        /**
         * @description What a program can do about it. `bad_input`: a word, a number or a file that was given is to be mended, always with the status 422; `refused` is said of the request itself, whatever it asks for.
         * @enum {string}
         */
        ErrorKind: "bad_input" | "not_found" | "conflict" | "read_only" | "full" | "unavailable" | "damaged" | "refused";
        /** @description How the 21 errors are found from lengths, by the names of the flags of `axiometry volumetric identify`; all may be left out. */
        ErrorsOptions: {
            /** @enum {unknown} */
            curves?: "b-spline" | "legendre" | "nodes";
            /** @description Of all axes, or of X, Y, Z; at most 240 of all together. Left out: as many as the lengths support. */
            spans?: number | number[];
            /** @enum {unknown} */
            reversal?: "none" | "constant" | "curves";
            /** @description By how much slopes of curves change over an axis, standard deviation of displacements in µm and of rotations in µrad. */
            smoothness?: ("none" | "auto") | number | number[];
            /** @enum {unknown} */
            drift?: "auto" | "none" | "linear";
            find_breaks?: boolean;
            find_outliers?: boolean;
            find_part_scales?: boolean;
            /** @description Of recordings, in their order: `1`, `5-8`. */
            parts?: string[];
            /** @description The lengths shown fall where the reflector recedes. */
            reversed?: boolean;
            recording?: components["schemas"]["RecordingOptions"];
        };
        Evaluated: {
            result: components["schemas"]["Result"];
            readings: components["schemas"]["Readings"];
            /** @description Of all limits together; null without any. */
            verdict: components["schemas"]["Verdict"] | null;
            shown: components["schemas"]["Shown"][];
            from_archive: components["schemas"]["FromArchive"];
            /** @description Whether the date of the test says that there is none, since nothing was measured. */
            simulated_undated: boolean;
            /** @description The evaluation took. */
            milliseconds: number;
        };
        EvaluatedLine: {
            id: string;
            standard: string;
            direction: components["schemas"]["Place"] | null;
            slope: {
                um_per_m: number;
                u_um_per_m: number;
                /** @description Of U for 95.45 %, Student's t; 2 where a kept result has none; null where nothing tells the scatter. */
                k?: number | null;
            };
            distances_mm: number[];
            length_difference: {
                station_uncertainty_mm: number[];
                bounds_um: number[];
                negligible_from_mm: number | null;
            } | null;
            beam_angle_most_deg: number;
            breaks: {
                before_reading: number;
                jump_mm: number;
            }[];
            dead_paths: {
                first_reading: number;
                readings: number;
                dead_path_mm: number;
                u_mm: number;
                ties: number;
                tied: boolean;
            }[];
            test: components["schemas"]["Result"];
        };
        EvaluationForm: {
            /** Format: binary */
            lengths: string;
            /**
             * Format: binary
             * @description The plan whose lines were measured.
             */
            plan: string;
            /**
             * Format: binary
             * @description As it was located, in place of the plan's.
             */
            station?: string;
            /**
             * Format: binary
             * @description Limits by travel as CSV.
             */
            tolerances?: string;
            /** @description JSON: LinesOptions. */
            options?: string;
        };
        ExamplesLoaded: {
            /** @description How many. */
            tests: number;
        };
        Expanded: {
            /** @description Standard uncertainty. */
            u: number;
            /** @description Expanded uncertainty. */
            U: number;
            k: number;
            /** @description Effective degrees of freedom; null when infinite. */
            nu_eff: number | null;
            /**
             * @description From what k was found.
             * @enum {string}
             */
            coverage: "normal" | "degrees-of-freedom" | "correlated";
        };
        ExpansionCorrection: {
            machine: components["schemas"]["ExpansionPart"];
            equipment: components["schemas"]["ExpansionPart"] | null;
            datum_mm: number;
            smallest_um: number;
            largest_um: number;
        };
        ExpansionPart: {
            expansion_um_per_m_C: number;
            start_C: number;
            end_C: number;
            sensors: number;
        };
        FactorUncertainty: {
            departure: number;
            u: number;
            u_linear: number;
            u_exact: number;
        };
        /** @description Every answer with a status of 400 or more. */
        Failure: {
            error: components["schemas"]["Problem"];
        };
        Field: {
            /** @description Group and member, as `--set` takes it: `machine.serial_number`. */
            key: string;
            group: string;
            title: string;
            /** @enum {string} */
            type: "text" | "number" | "boolean" | "choice" | "numbers" | "records";
            /** @description Of numbers, on a linear axis. */
            unit_linear: string;
            /** @description The same on a rotary axis. */
            unit_rotary: string;
            /** @description Of ISO 230-2; empty where the standard does not ask for it. */
            clause: string;
            minimum: number | null;
            maximum: number | null;
            choices: string[];
            /** @description Of records. */
            columns: {
                key: string;
                title: string;
                /** @enum {string} */
                type: "text" | "number";
                unit: string;
            }[];
            description: string;
            /** @description Whether clause 8.1 wants it in a report. */
            wanted: boolean;
        };
        /** @description Of the displacement of the tool point over the nodes of a grid. */
        FieldSizes: {
            largest_um: number;
            largest_u_um: number;
            largest_at_mm: number[];
            mean_um: number;
            percent_95_um: number;
        };
        FigureList: {
            figures: {
                id: number;
                title: string;
            }[];
        };
        FigureOfTest: {
            parameter: components["schemas"]["Parameter"];
            value: number;
            /** @description Of record; null where its method states the interval alone. */
            U: number | null;
            /** @description Ends of the stated interval. */
            low: number | null;
            high: number | null;
            /** @description Of record; null also of a version from before it was kept. */
            method: components["schemas"]["Method"] | null;
            limit: number | null;
            verdict: components["schemas"]["Verdict"] | null;
        };
        FileForm: {
            /** Format: binary */
            file?: string;
            /** @description An import profile as JSON text, at most 64 KiB, without a file name: how the only file of the form is to be read. It is kept with the tests. */
            profile?: string;
        };
        Finding: {
            /** @description Stable. */
            id: string;
            clause: string;
            /** @enum {string} */
            severity: "departure" | "missing" | "note";
            message: string;
            /** @description Keys of `/api/vocabulary` whose statement would answer it; left out where there is none, and by older programs. */
            fields?: string[];
        };
        /** @description What an evaluation took from the archive beside the test itself: inputs of instruments that neither the file nor the changes state, calibrations that held on the day of the test, and the limits of the axis. They are kept with a version as they were on its day. */
        FromArchive: {
            instruments: {
                instrument: components["schemas"]["Id"];
                version: number;
                name: string;
                inputs: components["schemas"]["Changes"];
                /** @description Inputs that do not go with what the test itself states. */
                left_out?: components["schemas"]["Changes"];
            }[];
            calibrations: components["schemas"]["Calibration"][];
            /** @description Its limits, each of which holds where nothing else limits its parameter. */
            axis: {
                axis: components["schemas"]["Id"];
                version: number;
                limits: components["schemas"]["Limit"][];
                /** @description Day of that version of the axis. */
                set_on?: string;
            } | null;
        };
        /** @description What is left out is as usual. */
        GivenOptions: {
            /** @description Beside Annex A, which is always there. */
            methods?: ("gum" | "monte-carlo")[];
            /** @description Of the Monte Carlo method; null: until two digits are stable. */
            trials?: number | null;
            seed?: components["schemas"]["Seed"];
            /** @description Of intervals: 0.95. */
            coverage?: number;
            /** @description As `--correct` takes them: `nde`, `air=ciddor`. */
            corrections?: string[];
            temperatures?: components["schemas"]["KeptTemperatures"];
        };
        /** @description What is null or left out is chosen by the planner. */
        GivenPlanRequest: {
            axis: string;
            kind: components["schemas"]["AxisKind"];
            from: number;
            to: number;
            /** @description null: chosen by the planner. */
            positions?: number[] | null;
            /** @description How many; null: what the standard asks for. */
            targets?: number | null;
            cycle?: components["schemas"]["Cycle"];
            runs?: number | null;
            /** @description mm/min or °/min. */
            feed?: number | null;
            dwell_s?: number | null;
            overrun?: number | null;
            seed?: number | null;
            /** @description More of `axiometry plan`, by the names of its flags. */
            further?: {
                [key: string]: string;
            };
        };
        GumBudget: {
            measurand: components["schemas"]["Measurand"];
            up_down_correlation: number;
            factors_um_per_m: {
                machine_thermal: components["schemas"]["FactorUncertainty"] | null;
                device_thermal: components["schemas"]["FactorUncertainty"] | null;
                alignment: components["schemas"]["FactorUncertainty"] | null;
            };
            sources: {
                key: string;
                symbol: string;
                title: string;
                source: string;
                distribution: string | null;
                u: number | null;
                unit: string;
                note?: string;
            }[];
            /** @description |c| u of every source. */
            contributions: {
                key: string;
                u: components["schemas"]["ParameterNumbers"];
            }[];
            positions: {
                target: number;
                up: components["schemas"]["PositionComponents"] | null;
                down: components["schemas"]["PositionComponents"] | null;
                mean: components["schemas"]["Expanded"] | null;
            }[];
            notes: string[];
        };
        GumOutput: {
            value: number;
        } & components["schemas"]["Expanded"];
        GumOutputs: {
            A: components["schemas"]["GumOutput"] | null;
            A_up: components["schemas"]["GumOutput"] | null;
            A_down: components["schemas"]["GumOutput"] | null;
            E: components["schemas"]["GumOutput"] | null;
            E_up: components["schemas"]["GumOutput"] | null;
            E_down: components["schemas"]["GumOutput"] | null;
            M: components["schemas"]["GumOutput"] | null;
            R: components["schemas"]["GumOutput"] | null;
            R_up: components["schemas"]["GumOutput"] | null;
            R_down: components["schemas"]["GumOutput"] | null;
            B: components["schemas"]["GumOutput"] | null;
            B_mean: components["schemas"]["GumOutput"] | null;
        };
        Health: {
            /** @constant */
            status: "ok";
            program: components["schemas"]["Program"];
            store: {
                /** @enum {string} */
                kind: "sqlite" | "postgresql";
                /** @description File or address, never with a password. */
                location: string;
                /** @description Number of the store's last migration. */
                schema: number;
                writable: boolean;
                /** @description Of a store that cannot be written. */
                why_not: string | null;
                counts: components["schemas"]["Counts"];
            };
            limits: {
                /** @description Size of the largest body that is taken. */
                upload_bytes: number;
            };
            /** @description Whether one is asked for. */
            token: boolean;
        };
        /** @description What is told who has not shown the token. */
        HealthStatus: {
            /** @constant */
            status: "ok";
        };
        /** @description Number of a thing in the archive, counted from 1 without gaps. */
        Id: number;
        /** @description How a table of numbers in a file of an unknown layout is to be read. */
        ImportProfile: {
            /** @constant */
            format: "axiometry-import-profile/1";
            /**
             * @description Encoding of the text; auto finds it out.
             * @enum {unknown}
             */
            encoding: "auto" | "utf-8" | "utf-16" | "gbk" | "windows-1252" | "latin-1";
            /**
             * @description What stands between the columns.
             * @enum {unknown}
             */
            delimiter: "comma" | "semicolon" | "tab" | "blanks";
            /**
             * @description Decimal mark of the numbers. With comma as delimiter too, every number has a comma of its own.
             * @enum {unknown}
             */
            decimal_mark: "point" | "comma";
            /** @description Lines that begin with it are passed over; empty: none are. */
            comment: string;
            /** @description Lines to pass over before anything is looked at. */
            skip_lines: number;
            /** @description Lines of the header: 0 without one, 2 when a line of units follows the names. Where columns have names here, the header is the first line that holds them; else the first line that is no comment. */
            header_lines: number;
            /** @description A line that begins with it ends the table; empty: the file does. */
            end: string;
            /**
             * @description long: one reading per row; wide: one column per run, one row per target; transposed: one row per run, the targets across in the header.
             * @enum {unknown}
             */
            layout: "long" | "wide" | "transposed";
            /** @description From left to right. In a transposed table the last one stands for all that follow. */
            columns: {
                /**
                 * @description What stands in the column.
                 * @enum {unknown}
                 */
                role: "ignore" | "target" | "deviation" | "position" | "direction" | "run" | "time" | "label";
                /** @description Its name in the header, which is then looked for in the file; left out: not compared. */
                name?: string;
                /**
                 * @description Unit of its readings, where it is not reading_unit.
                 * @enum {unknown}
                 */
                unit?: "um" | "mm" | "nm" | "m" | "in" | "uin" | "arcsec" | "deg" | "mdeg" | "rad" | "mrad" | "urad" | null;
                /**
                 * @description Direction of approach of all its readings.
                 * @enum {unknown}
                 */
                direction?: "up" | "down" | null;
                /** @description Run of all its readings, counted from 1. */
                run?: number;
            }[];
            /**
             * @description Unit of the targets.
             * @enum {unknown}
             */
            target_unit: "um" | "mm" | "nm" | "m" | "in" | "uin" | "arcsec" | "deg" | "mdeg" | "rad" | "mrad" | "urad" | null;
            /**
             * @description Unit of the readings.
             * @enum {unknown}
             */
            reading_unit: "um" | "mm" | "nm" | "m" | "in" | "uin" | "arcsec" | "deg" | "mdeg" | "rad" | "mrad" | "urad" | null;
            /**
             * @description Where the direction of approach comes from: a column; names of columns or labels of rows; motion, the step from the target before; visits to a target (transposed: rows) in turn; run-parity, runs counted one way each; or all approaches are up, or down.
             * @enum {unknown}
             */
            direction: "column" | "names" | "motion" | "visits" | "run-parity" | "up" | "down" | null;
            /**
             * @description Direction of the first run or visit, for run-parity and visits.
             * @enum {unknown}
             */
            first_direction: "up" | "down";
            /** @description Words for up in the column of directions, beside the usual ones. */
            up_words: string[];
            /** @description Words for down in the column of directions, beside the usual ones. */
            down_words: string[];
            /**
             * @description Where the number of the run comes from: a column or label, names of columns, or the repetition of targets.
             * @enum {unknown}
             */
            runs: "column" | "names" | "repetition";
            /** @description Number of the first run in its column. */
            first_run: number;
            /**
             * @description 1: readings are as they stand; -1: their sign is the other one (target minus actual).
             * @enum {unknown}
             */
            sign: 1 | -1;
        };
        Instrument: {
            role: string;
            manufacturer: string;
            type: string;
            serial_number: string;
            certificate: string;
            calibrated_on: string;
            calibration_due: string;
            /** @description Metadata that a test with this instrument takes from it. */
            inputs: components["schemas"]["Changes"];
            notes: string;
        } & components["schemas"]["Entity"];
        InstrumentEdit: {
            role?: string;
            manufacturer?: string;
            type?: string;
            serial_number?: string;
            certificate?: string;
            calibrated_on?: string;
            calibration_due?: string;
            /** @description Metadata that a test with this instrument takes from it. */
            inputs?: components["schemas"]["Changes"];
            notes?: string;
        } & (components["schemas"]["EditNote"] & components["schemas"]["SentBack"]);
        InstrumentList: {
            instruments: components["schemas"]["Instrument"][];
        };
        InstrumentVersions: {
            versions: components["schemas"]["Instrument"][];
        };
        /** @description Its ends, the smaller first. */
        Interval: [
            number,
            number
        ];
        /** @enum {string} */
        Language: "en" | "de" | "fr";
        IssueRequest: {
            /** @description A writer of the vocabulary, or `json`. */
            extension: string;
            language?: components["schemas"]["Language"];
            /** @enum {string} */
            decimal?: "point" | "comma";
            unit?: components["schemas"]["ShownUnit"] | null;
            /** @description The latest when left out. */
            version?: number | null;
            reason?: string;
        };
        /**
         * @description A verdict, or that there is no value to decide about.
         * @enum {string}
         */
        Judged: "conforms" | "does not conform" | "undecided" | "not applicable";
        /** @description docs/results.md, `tolerances`, explains every member. */
        Judgement: {
            parameter: components["schemas"]["Parameter"];
            limit: number;
            source: components["schemas"]["LimitSource"];
            verdict: components["schemas"]["Judged"];
            /** @enum {string} */
            rule: "simple" | "iso14253-1" | "guard-band";
            replaced: components["schemas"]["ReplacedLimit"][];
            /** @description Why nothing is decided although there is a value. */
            withheld: string | null;
            /** @description What mends that: corrections of `/api/vocabulary`, or statements by their keys; left out where nothing of it does, and by older programs. */
            remedy?: {
                corrections: string[];
                fields: string[];
            };
            u: number | null;
            u_degrees_of_freedom: number | null;
            u_method: components["schemas"]["Method"] | null;
            u_measurand: components["schemas"]["Measurand"] | null;
            guard_band: number | null;
            rejection_band: number | null;
            acceptance_limit: number | null;
            rejection_limit: number | null;
            probability_conforming: number | null;
            probability_least: number | null;
            probability_most: number | null;
            consumer_risk: number | null;
            producer_risk: number | null;
        };
        /** @description A control whose tables of compensation are written and read. */
        CompensatedControl: {
            /** @description `linuxcnc` */
            id: string;
            title: string;
            /** @description Of its files. */
            extension: string;
            limits: components["schemas"]["CompensationLimits"];
            /** @description Those that the control has a use for; others are refused. */
            options: ("number" | "resolution" | "magnification" | "largest" | "steps_per_unit" | "turned_sign" | "inch")[];
            /** @description Whether the spacing of its tables may be a parameter of the control alone: `step` of a table that is read. */
            read_step: boolean;
            /** @description Whether it has tables by which the position of one axis moves another: `/api/volumetric/compensation`. */
            cross: boolean;
            /** @description What a positive number in the file does. */
            sign: string;
            /** @description How the table gets into the control. */
            loading: string;
            /** @description What of this format was seen in a file, a source or a manual. */
            verified: string;
            /** @description What was not; empty where nothing. */
            inferred: string;
            /** @description What a positive number does with a turned sign; empty where the sign is verified. */
            turned_sign: string;
            /** @description How it calls its number for the reversal beside one curve; empty where none is known. */
            backlash: string;
        };
        /** @description What a table of a control can hold. */
        CompensationLimits: {
            /** @description Most positions of a table; 1: a backlash alone; null: not limited. */
            points: number | null;
            /** @description The only spacing that there is, mm; null: any. */
            step: number | null;
            equidistant: boolean;
            /** @enum {string} */
            curves: "both-ways" | "with-backlash" | "each-way";
            linear: boolean;
            rotary: boolean;
        };
        /** @description Mean deviations at a target, native unit; null in a direction that was not measured. */
        CompensationMean: {
            /** @description mm or ° */
            target: number;
            up: number | null;
            down: number | null;
        };
        /** @description What a re-test has shown. */
        CompensationRetest: {
            parameters: components["schemas"]["ParameterNumbers"];
            means: components["schemas"]["CompensationMean"][];
            /** @description Of the table that acts: 1 the whole of it, 0 nothing, −1 the opposite. */
            share?: number;
            /** @description Standard uncertainty of the share. */
            u?: number;
            /** @description Of the change, by the share alone; 0 to 1. */
            explained?: number;
            /** @description Means that both tests have. */
            compared?: number;
            /** @description Of the re-test; left out by programs that did not state it. */
            source?: components["schemas"]["ResultSource"];
        };
        /** @description The periodic part of the readings, and whether the table takes it along. */
        CompensationPeriodic: {
            /** @description mm or ° */
            period: number;
            /** @enum {string} */
            choice: "keep" | "leave";
            up: components["schemas"]["CompensationPeriodicWay"] | null;
            down: components["schemas"]["CompensationPeriodicWay"] | null;
        };
        /** @description To within what positions are known with the table in the control: equations (7) to (10) of docs/theory/compensation.md. Native unit. */
        CompensationKnown: {
            /** @description The largest amount of a residual and U at a target, with the size of what was not corrected; null where any is not known: notes tell why. */
            at_targets: number | null;
            /** @description And between them. */
            anywhere: number | null;
            /** @description The mean of what the table leaves: the new zero that residuals and U are against. */
            zero: number;
            targets: {
                target: number;
                up: components["schemas"]["CompensationKnownMean"] | null;
                down: components["schemas"]["CompensationKnownMean"] | null;
            }[];
            between_up: components["schemas"]["CompensationBetween"];
            between_down: components["schemas"]["CompensationBetween"];
            notes: string[];
        };
        /** @description At a target in one direction. */
        CompensationKnownMean: {
            /** @description Mean deviation that is left. */
            residual: number;
            /** @description Of it what the digits of the file make. */
            rounding: number;
            /** @description Standard uncertainty of the mean deviation. */
            u_mean: number | null;
            /** @description Scatter of the approaches. */
            s: number | null;
            /** @description Of the position that one approach ends at. */
            u: number | null;
            U: number | null;
            k: number | null;
        };
        /** @description Between targets that follow each other, in one direction. */
        CompensationBetween: {
            /** @description Standard uncertainty of the straight line between two means. */
            q: number | null;
            gaps: {
                from: number;
                to: number;
                /** @description The largest by amount. */
                residual: number;
                u: number | null;
                U: number | null;
                k: number | null;
            }[];
        };
        /** @description Of one direction; null where the targets do not tell it. */
        CompensationPeriodicWay: {
            /** @description Native unit. */
            amplitude: number;
            /** @description Its standard uncertainty. */
            u: number;
            /** @description That noise makes it so large; 0 to 1. */
            chance: number;
            significant: boolean;
        };
        /** @description As `axiometry compensate --json` writes it; docs/results.md explains it. Texts in the language of the request. */
        CompensationResult: {
            /** @description In a report of what was withdrawn: true; else left out. */
            withdrawn?: boolean;
            /** @description `linuxcnc` */
            control: string;
            axis: string;
            /** @enum {string} */
            kind: "linear" | "rotary";
            unit: components["schemas"]["Unit"];
            /** @description What a positive number in the file does. */
            sign: string;
            /** @description Whether that is the other one than was inferred of the control; left out by programs that could not turn it. */
            turned_sign?: boolean;
            table: components["schemas"]["CompensationNode"][];
            /** @description The table that was active during the test. */
            existing?: components["schemas"]["CompensationNode"][];
            before: components["schemas"]["ParameterNumbers"];
            predicted: components["schemas"]["ParameterNumbers"];
            /** @description What re-tests will show if the axis stays as it is. */
            expected_retest?: {
                median: components["schemas"]["ParameterNumbers"];
                percent_95: components["schemas"]["ParameterNumbers"];
                trials: number;
            };
            /** @description Left out by programs that did not state it. */
            known_to_within?: components["schemas"]["CompensationKnown"];
            least_squares: components["schemas"]["ParameterNumbers"];
            interpolated: components["schemas"]["ParameterNumbers"];
            /** @description What no table removes. */
            scatter: components["schemas"]["ParameterNumbers"];
            before_means: components["schemas"]["CompensationMean"][];
            predicted_means: components["schemas"]["CompensationMean"][];
            /** @description null where nobody says a period; left out by programs that did not look for it. */
            periodic?: components["schemas"]["CompensationPeriodic"] | null;
            smoothing: number | null;
            retest?: components["schemas"]["CompensationRetest"];
            limits: components["schemas"]["CompensationLimits"];
            verified: {
                verified: string;
                inferred: string;
            };
            findings: components["schemas"]["VolumetricFinding"][];
            /** @description Of the test; left out by programs that did not state it, as is the next. */
            source?: components["schemas"]["ResultSource"];
            program?: components["schemas"]["Program"];
        };
        /** @description What the table depends on beside the test. As the flags of `axiometry compensate`. */
        CompensationOptions: {
            /** @description Of `/api/controls`. */
            control: string;
            /** @description As the control names it; left out: as the test does. */
            axis?: string;
            /** @description First position, mm or °. */
            start?: number;
            end?: number;
            /** @description Spacing, mm or °; left out: a round one that fits. */
            step?: number;
            points?: number;
            /** @description Reference point of the machine, where the table does nothing. */
            reference?: number;
            /** @enum {string} */
            method?: "least-squares" | "interpolation";
            smooth?: boolean;
            /** @description Beyond the targets the value at the last one, which nobody measured there. */
            hold_ends?: boolean;
            /**
             * @description Both-ways: one curve although the control has one for each direction. With-backlash: one, and a number for the reversal beside it.
             * @enum {string}
             */
            curves?: "both-ways" | "with-backlash";
            inch?: boolean;
            number?: number;
            /** @description What one count stands for, µm or ″. */
            resolution?: number;
            magnification?: number;
            largest?: number;
            /** @description Steps per mm or ° of a control without tables. */
            steps_per_unit?: number;
            /** @description The other sign than was inferred of the control; refused where it is verified. */
            turned_sign?: boolean;
            /**
             * @description Whether the periodic part of the readings goes into the table; left out: keep.
             * @enum {string}
             */
            periodic?: "keep" | "leave";
            /** @description Of the periodic part, mm or °; left out: axis.expected_period of the test. */
            period?: number;
            /**
             * @description Of the existing table; left out: that of the new one.
             * @enum {string}
             */
            existing_unit?: "mm" | "inch";
        };
        CompensationNode: {
            /** @description mm or ° */
            position: number;
            /** @description Added on the way up, native unit; a positive number moves the axis in the positive direction. */
            up: number;
            down: number;
        };
        CompensationForm: {
            /** @description JSON: CompensationOptions. */
            options: string;
            /**
             * Format: binary
             * @description The table that was active while the test was measured.
             */
            existing?: string;
            /** @description Only where it is kept. */
            notes?: string;
        };
        /** @description Of lines, of the 21 errors, or of straightness, angles and squareness, as the kind of the calibration says. */
        KeptOptions: components["schemas"]["LinesOptions"] | components["schemas"]["ErrorsOptions"] | components["schemas"]["MotionOptions"];
        /** @description How lengths along lines are evaluated, by the names of the flags of `axiometry tracking evaluate`; all may be left out. */
        LinesOptions: {
            /** @description `A=10um` of all lines, `xy:E=20um` of one. */
            tolerances?: string[];
            /** @description A name in the file of tolerances. */
            tolerance_table?: string;
            /** @description `simple`, `iso14253-1` or `guard-band=2um`. */
            rule?: string;
            /** @description Metadata over what the file says: `machine.name=Mill 5`. */
            set?: string[];
            /** @description The lengths shown fall where the reflector recedes. */
            reversed?: boolean;
            find_breaks?: boolean;
            break_threshold_mm?: number;
            methods?: ("gum" | "monte-carlo")[];
            trials?: number | null;
            seed?: number | string | null;
            coverage?: number | null;
            /** @enum {unknown} */
            type_a?: "pooled" | "t-scaled" | "resampled" | null;
            recording?: components["schemas"]["RecordingOptions"];
        };
        /** @description How readings of straightness, angles and squareness are evaluated; all may be left out. */
        MotionOptions: {
            /**
             * @description `none` of angles alone.
             * @enum {unknown}
             */
            reference?: "least-squares" | "end-points" | "none";
            /** @description A and B of its uncertainty A + B L, k = 2. */
            instrument?: number[];
            /** @description Of one file: `EYX`. */
            error?: string;
            /** @description Of each file which way its readings are positive: `+Y`. */
            positive?: string[];
            /** @description Of angles: a tool point, whose displacement is told. */
            offset_mm?: number[];
            square_error_arcsec?: number;
            square_uncertainty_arcsec?: number;
        };
        /** @description What a continuous recording does not say itself, by the names of the flags of `axiometry capture`. */
        RecordingOptions: {
            [key: string]: string;
        };
        TableForm: {
            /** @description JSON: axis, inch, number, reference, resolution, magnification, largest, step, steps_per_unit of CompensationOptions, and `kind`: linear or rotary. */
            options?: string;
            /** Format: binary */
            table: string;
        };
        /** @description What a control adds with a table loaded, by its own rule. */
        ReadTable: {
            control: string;
            /** @enum {string} */
            kind: "linear" | "rotary";
            unit: components["schemas"]["Unit"];
            table: components["schemas"]["CompensationNode"][];
        };
        /** @description A table that is not kept. */
        MadeCompensation: {
            result: components["schemas"]["CompensationResult"];
            /** @description As it would be kept. */
            file_name: string;
            /** @description The file for the control. */
            table: string;
        };
        /** @description A figure of another rule, and the parameter of ISO 230-2:2014 that it is taken for. */
        RuleFigure: {
            key: string;
            /** @description `P_s,max`; null where the rule has none that is known. */
            symbol: string | null;
            title: string;
            /** @description Of the rule, where it is known. */
            clause: string | null;
            value: number | null;
            /** @description Why there is no value. */
            absent_because: string | null;
            interval: {
                low: number;
                high: number;
                u: number;
                stable: boolean;
            } | null;
            /** @description After trials. */
            no_interval_because: string | null;
            /** @description Of figures that the rule divides by the travel. */
            share_of_travel: number | null;
            /** @enum {string} */
            evidence: "text" | "makers-text" | "program" | "second-hand";
            /** @description Must stand wherever the figure does. */
            evidence_text: string;
            checked_against_text: boolean;
            /** @description Key of the parameter: `A_up`. */
            beside: string | null;
            beside_value: number | null;
            difference: number | null;
            relative_difference: number | null;
            /** @description In what the formulas differ; null where both always have one value. */
            departs_by: string | null;
        };
        ComparedFigure: {
            /** @description The numbers as reports show them; empty where there are none. */
            shown: {
                value: string;
                interval: string;
                share_of_travel: string;
                beside_value: string;
                difference: string;
                relative_difference: string;
            };
        } & components["schemas"]["RuleFigure"];
        RuleOfComparison: {
            /** @description `vdi-dgq-3441` */
            id: string;
            name: string;
            /** @description What its figures are and are not. */
            remark: string;
        };
        ComparedRule: {
            figures: components["schemas"]["ComparedFigure"][];
        } & components["schemas"]["RuleOfComparison"];
        /** @description One test by several rules. Nothing here states conformity with any of them. */
        ComparisonOfRules: {
            /** @description Beside which the figures of other rules stand. */
            standard: string;
            /** @enum {string} */
            result: "rules-compared";
            axis: {
                name: string;
                kind: components["schemas"]["AxisKind"];
            };
            unit: components["schemas"]["Unit"];
            /** @description Whether the test departs in nothing from `standard`, as far as it was looked at. */
            conforming: boolean;
            /** @description Words that must stand wherever the figures do. */
            label?: string;
            parameters: components["schemas"]["ParameterNumbers"];
            /** @description What is not stated, and what intervals are of. */
            remarks: string[];
            uncertainty: {
                /** @enum {string} */
                method: "monte-carlo";
                measurand: components["schemas"]["Measurand"];
                coverage: number;
                trials: number;
                seed: components["schemas"]["Seed"];
                stable: boolean;
                notes: string[];
            } | null;
            /** @description Figures that must not be compared as if they were one; in place of a clause stands the rule. */
            warnings: components["schemas"]["Finding"][];
            findings: components["schemas"]["Finding"][];
        };
        RulesCompared: {
            rules: components["schemas"]["ComparedRule"][];
        } & components["schemas"]["ComparisonOfRules"];
        /** @description As `axiometry compare-rules --json` writes it. */
        RulesReport: {
            rules: ({
                figures: components["schemas"]["RuleFigure"][];
            } & components["schemas"]["RuleOfComparison"])[];
            metadata: components["schemas"]["Metadata"];
            source: components["schemas"]["ResultSource"];
            program: components["schemas"]["Program"];
        } & components["schemas"]["ComparisonOfRules"];
        /** @description Of a fit. Without u and U where it is not significant. */
        FittedValue: {
            value: number;
            u: number | null;
            U: number | null;
        };
        /** @description Of one direction of approach: lengths of positions in mm or °, deviations in the result's unit. */
        PeriodicDirection: {
            /** @enum {string} */
            direction: "up" | "down";
            targets: number;
            runs: number;
            origin: number;
            period_known: boolean;
            period: components["schemas"]["FittedValue"];
            amplitude: components["schemas"]["FittedValue"];
            phase_deg: components["schemas"]["FittedValue"];
            phase_at_zero_deg: components["schemas"]["FittedValue"];
            harmonics: {
                order: number;
                amplitude: components["schemas"]["FittedValue"];
                phase_deg: components["schemas"]["FittedValue"];
                chance: number;
                in_curve: boolean;
            }[];
            peak_to_valley: components["schemas"]["FittedValue"];
            range_about_line: number;
            range_of_residuals: number;
            residual_sd: number;
            degrees_of_freedom: number;
            coverage_factor: number;
            scatter_of_means: number | null;
            slope: components["schemas"]["FittedValue"];
            offset: components["schemas"]["FittedValue"];
            false_alarm_probability: number;
            false_alarm_probability_correlated: number;
            residual_correlation: number;
            significant: boolean;
            periods_covered: number;
            targets_per_period: number;
            further_period: {
                period: number;
                amplitude: number;
                false_alarm_probability: number;
            } | null;
            points: {
                target: number;
                deviation: number;
                line: number;
                curve: number;
                residual: number;
            }[];
        };
        PeriodicError: {
            standard: string;
            clause: string;
            /** @constant */
            result: "periodic-error";
            axis: {
                name: string;
                /** @enum {string} */
                kind: "linear" | "rotary";
            };
            /** @enum {string} */
            unit: "um" | "arcsec";
            /** @description Whether nothing departs from the test of Annex C. */
            conforming: boolean;
            label?: string;
            directions: components["schemas"]["PeriodicDirection"][];
            findings: components["schemas"]["Finding"][];
            metadata: components["schemas"]["Metadata"];
            source: components["schemas"]["ResultSource"];
            program: components["schemas"]["Program"];
        };
        /** @description As `axiometry periodic --json` writes it. */
        PeriodicReport: components["schemas"]["PeriodicError"];
        PeriodicShown: {
            document: components["schemas"]["ReportDocument"];
        } & components["schemas"]["PeriodicError"];
        /** @description A report in its parts, in the words of the reader. */
        ReportDocument: {
            kind: string;
            title: string;
            edition: string;
            status: components["schemas"]["ReportNotice"][];
            sections: {
                id: string;
                title: string;
                blocks: components["schemas"]["ReportBlock"][];
            }[];
        };
        /** @description A piece of text in one style. */
        TextRun: {
            text: string;
            italic?: boolean;
            bold?: boolean;
            /** @enum {string} */
            script?: "sub" | "super";
        };
        ReportCell: {
            text: components["schemas"]["TextRun"][];
            /** @enum {string} */
            tone: "normal" | "quiet" | "good" | "caution" | "bad";
        };
        ReportNotice: {
            /** @enum {string} */
            tone: "normal" | "quiet" | "good" | "caution" | "bad";
            heading: components["schemas"]["TextRun"][];
            lines: components["schemas"]["TextRun"][][];
        };
        ReportTable: {
            /** @constant */
            kind: "table";
            caption: components["schemas"]["TextRun"][];
            groups: {
                head: components["schemas"]["TextRun"][];
                columns: number;
            }[];
            columns: {
                head: components["schemas"]["TextRun"][];
                /** @enum {string} */
                align: "start" | "centre" | "decimal";
                names_row: boolean;
                /** @description Running text, which wraps. */
                takes_space: boolean;
            }[];
            rows: components["schemas"]["ReportCell"][][];
            notes: components["schemas"]["TextRun"][][];
        };
        ReportFigure: {
            /** @constant */
            kind: "figure";
            title: string;
            description: string;
            svg: string;
        };
        ReportBlock: components["schemas"]["ReportTable"] | components["schemas"]["ReportFigure"] | {
            /** @constant */
            kind: "paragraph";
            /** @enum {string} */
            tone: "normal" | "quiet" | "good" | "caution" | "bad";
            text: components["schemas"]["TextRun"][];
        } | {
            /** @constant */
            kind: "notice";
            notice: components["schemas"]["ReportNotice"];
        } | {
            /** @constant */
            kind: "facts";
            title: string;
            facts: {
                name: components["schemas"]["TextRun"][];
                value: components["schemas"]["ReportCell"];
            }[];
        };
        CalibrationResult: components["schemas"]["TrackingEvaluation"] | components["schemas"]["VolumetricResult"] | components["schemas"]["MotionResult"];
        CompensationFigure: {
            /** @description `E` */
            parameter: string;
            before: number | null;
            predicted: number | null;
            /** @description What 95 % of re-tests show less than, if the axis stays as it is. */
            percent_95: number | null;
            retest: number | null;
        };
        CompensationTest: {
            id: components["schemas"]["Id"];
            version: number;
            title: string;
            measured_on: string;
            /** @description The latest version of the test. */
            latest: number;
            /** @description Now. */
            withdrawn: boolean;
            /** @description The latest version differs from the one that was used in metadata, options or axis. */
            revised: boolean;
        };
        CompensationHead: {
            id: components["schemas"]["Id"];
            version: number;
            /** Format: date-time */
            made_at: string;
            control: {
                id: string;
                title: string;
            };
            /** @description Of the table. */
            file_name: string;
            test: components["schemas"]["CompensationTest"];
            retest: components["schemas"]["CompensationTest"] | null;
            machine: components["schemas"]["Reference"] | null;
            axis: components["schemas"]["Reference"] | null;
            unit: components["schemas"]["Unit"];
            notes: string;
            withdrawn: boolean;
            /** @description Findings after which the table should not be used as it is: those that count, and what became of its tests since. */
            serious: number;
            /** @description Without those of a re-test that was withdrawn or revised since: they no longer count. */
            figures: components["schemas"]["CompensationFigure"][];
        };
        /** @description The newest first, at most 1000. */
        CompensationList: {
            compensations: components["schemas"]["CompensationHead"][];
        };
        KeptCompensation: {
            id: components["schemas"]["Id"];
            version: number;
            /** Format: date-time */
            made_at: string;
            control: {
                id: string;
                title: string;
            };
            /** @description Of the table. */
            file_name: string;
            test: components["schemas"]["CompensationTest"];
            retest: components["schemas"]["CompensationTest"] | null;
            machine: components["schemas"]["Reference"] | null;
            axis: components["schemas"]["Reference"] | null;
            unit: components["schemas"]["Unit"];
            notes: string;
            withdrawn: boolean;
            /** @description Findings after which the table should not be used as it is: those that count, and what became of its tests since. */
            serious: number;
            /** @description Without those of a re-test that was withdrawn or revised since: they no longer count. */
            figures: components["schemas"]["CompensationFigure"][];
            change: components["schemas"]["Change"];
            /** @description Which made it. */
            program: string;
            options: components["schemas"]["CompensationOptions"];
            result: components["schemas"]["CompensationResult"];
            /** @description What became of its tests since (test-withdrawn, test-revised, retest-withdrawn, retest-revised), then those of the result that still count: none of a re-test that no longer does. */
            findings: components["schemas"]["VolumetricFinding"][];
            /** @description The file for the control. */
            table: string;
            /** @description The table that was active while the test was measured. */
            existing: {
                name: string;
                sha256: string;
            } | null;
            table_sha256: string;
            versions: {
                version: number;
                change: components["schemas"]["Change"];
                retest: components["schemas"]["Id"] | null;
                withdrawn: boolean;
            }[];
        };
        CompensationRevision: {
            /** @description The version that was looked at. */
            base_version: number;
            reason?: string;
            /** @description A test of the archive that was measured with the table active; it is held against the prediction. null takes it away. */
            retest?: components["schemas"]["Id"] | null;
            notes?: string;
        };
        KeptCalibration: {
            id: components["schemas"]["Id"];
            version: number;
            kind: components["schemas"]["CalibrationKind"];
            title: string;
            machine: {
                id: components["schemas"]["Id"];
                name: string;
            } | null;
            measured_on: string;
            withdrawn: boolean;
            verdict: components["schemas"]["Verdict"] | null;
            /** @description Findings after which the result should not be used as it is. */
            serious: number;
            figures: components["schemas"]["CalibrationFigure"][];
            change: components["schemas"]["Change"];
            instrument: {
                id: components["schemas"]["Id"];
                name: string;
            } | null;
            notes: string;
            files: {
                /** @description `lengths`, `plan`, `station` or `machine`. */
                role: string;
                name: string;
                sha256: string;
            }[];
            /** @description Which evaluated it. */
            program: string;
            /** @description Only in the answer that it was kept: the others of exactly these files, withdrawn ones too. */
            same_files?: components["schemas"]["Id"][];
            options: components["schemas"]["KeptOptions"];
            versions: {
                version: number;
                change: components["schemas"]["Change"];
                title: string;
                withdrawn: boolean;
                /** @description Another one where it was evaluated again. */
                result_sha256: string;
            }[];
            /** @description After its kind: of lines as `axiometry tracking evaluate --json`, of the 21 errors as `axiometry volumetric identify --json`, of the others as their verb writes it, in the reader's language; docs/results.md explains it. What an earlier version of the program wrote may lack members. */
            result: components["schemas"]["CalibrationResult"];
        };
        /** @description A log of temperatures before and during the test (4.1), by the bytes of a document of the archive, with when the test was and what the parties agreed (7). */
        KeptTemperatures: {
            sha256: components["schemas"]["Sha256"];
            /** @description Of the file. */
            name: string;
            /** @description Moment of the first reading: 2026-03-02T09:00. */
            began?: string;
            /** @description Of the last; without it the times of the readings tell it, or the end of the log is taken for it. */
            ended?: string;
            /** @description What a sensor is of where its name does not say so. */
            sensors?: {
                name: string;
                /** @enum {string} */
                role: "machine" | "equipment" | "air" | "none";
            }[];
            lowest_C?: number;
            highest_C?: number;
            rate_C_per_h?: number;
            gradient_C?: number;
        };
        /** @description How much of a stretch of time was recorded. */
        RecordedShare: {
            recorded_h: number;
            whole_h: number;
            complete: boolean;
        };
        /** @description The surroundings of the test (4.1), by a log of temperatures or stated, against what was agreed (7). */
        Surroundings: {
            quantities: {
                /** @enum {string} */
                key: "lowest_C" | "highest_C" | "rate_C_per_h" | "rate_before_C_per_h" | "machine_gradient_C";
                title: string;
                unit: string;
                clause: string;
                /** @description null: not measured. */
                measured: number | null;
                agreed: number | null;
                /** @description Whether what is measured is on the word of who tested, by no log. */
                stated: boolean;
                /** @enum {string} */
                limit: "lowest" | "highest";
                /** @enum {string} */
                standing: "kept" | "exceeded" | "not-measured" | "not-agreed" | "known-in-part";
            }[];
            /** @description Whether any limit is. */
            exceeded: boolean;
            /** @description Whether nobody can say of a limit that it was kept. */
            open: boolean;
            /** @description Time that machine and equipment were soaked, h, as stated. */
            soaked_h: number | null;
            log_begin: string | null;
            began: string | null;
            /** @description As asked. */
            ended: string | null;
            /** @description Moment of the last reading by the times of the readings, where nobody told the end. */
            ended_by_readings: string | null;
            /** @description Whether it is known when in the log the test was. */
            test_placed: boolean;
            during: components["schemas"]["RecordedShare"] | null;
            /** @description Of the twelve hours before. */
            before: components["schemas"]["RecordedShare"] | null;
            sensors: {
                name: string;
                /** @enum {string} */
                role: "machine" | "equipment" | "air";
                readings: number;
                /** @description null of a sensor without a reading. */
                lowest_C: number | null;
                highest_C: number | null;
            }[];
            /** @description How the log was read. */
            remarks: string[];
            /** @description What of the time is not known. */
            gaps: string[];
            /** @description The log; null where there is none. */
            source: {
                file: string;
                sha256: components["schemas"]["Sha256"];
            } | null;
        };
        /** @description A mean deviation by the Monte Carlo method. */
        DrawnMean: {
            /** @description Measured. */
            value: number;
            mean: number;
            u: number;
            low: number;
            high: number;
        };
        LengthPart: {
            part: number;
            title: string;
            stops: number;
        };
        LengthParts: {
            kind: components["schemas"]["LengthPlanKind"];
            plan_id: string;
            parts: components["schemas"]["LengthPart"][];
            /** @description Of this plan, the newest first. */
            captures: components["schemas"]["Capture"][];
        };
        LengthPlan: components["schemas"]["TrackingPlanFile"] | components["schemas"]["VolumetricPlanFile"];
        /**
         * @description `lines`: a tracking plan, whose parts are its lines; `volume`: a volumetric plan, whose parts are its runs.
         * @enum {string}
         */
        LengthPlanKind: "lines" | "volume";
        LengthSubject: {
            kind: components["schemas"]["LengthPlanKind"];
            plan: components["schemas"]["LengthPlan"];
            /** @description From 1. 0, or left out: all lines of a plan of lines. */
            part?: number;
        };
        Limit: {
            parameter: components["schemas"]["Parameter"];
            value: number;
        };
        /**
         * @description Each gives way, parameter by parameter, to those after it: the axis of the archive, a tolerance table, the test's file, entered for this test, the command line.
         * @enum {string}
         */
        LimitSource: "axis" | "table" | "test" | "entered" | "user";
        /** @description Members of the query `options`. */
        LocateOptions: {
            tool_offset_mm?: components["schemas"]["Place"];
            near_mm?: components["schemas"]["Place"];
            machine_sigma_um?: number;
            ranging?: components["schemas"]["TrackingPlanFile"]["setup"]["ranging"];
        };
        Login: {
            token: string;
        };
        LostLine: {
            id: string;
            reason: string;
        };
        Machine: {
            axes: components["schemas"]["Axis"][];
            /** @description How many, without withdrawn ones. */
            tests: number;
            /** @description By the day it was measured or, where none is known, received. */
            latest_test: {
                id: components["schemas"]["Id"];
                measured_on: string;
                received_at: string;
                verdict: components["schemas"]["Verdict"] | null;
            } | null;
            /** @description Of each axis that has tests the latest, by the day it was measured or, where none is known, received. */
            latest_of_axes: {
                axis: components["schemas"]["Id"];
                id: components["schemas"]["Id"];
                /** @description Empty: no day is known. */
                measured_on: string;
                received_at: string;
                verdict: components["schemas"]["Verdict"] | null;
            }[];
        } & components["schemas"]["MachineVersion"];
        MachineEdit: {
            name: string;
            manufacturer?: string;
            type?: string;
            serial_number?: string;
            controller?: string;
            location?: string;
            notes?: string;
        } & (components["schemas"]["EditNote"] & components["schemas"]["SentBack"]);
        MachineList: {
            machines: components["schemas"]["Machine"][];
        };
        MachineVersion: {
            name: string;
            manufacturer: string;
            type: string;
            serial_number: string;
            controller: string;
            location: string;
            notes: string;
        } & components["schemas"]["Entity"];
        MachineVersions: {
            versions: components["schemas"]["MachineVersion"][];
        };
        /** @description Rows of X, Y, Z. */
        Matrix: number[][];
        /**
         * @description Of which the uncertainty is: what these approaches would have given with perfect instruments, or what the axis does in the long run.
         * @enum {string}
         */
        Measurand: "this-test" | "this-machine";
        /** @description A positioning test of one machine tool axis: what was tested, how, and the readings. */
        Metadata: {
            test?: {
                /** @description Report number. Number of the report or certificate. */
                report_number?: string | null;
                /** @description Date of test. Date of the test, ISO 8601 preferred. ISO 230-2:2014, 8.1. */
                date?: string | null;
                /** @description Name of inspector. Who made the test. ISO 230-2:2014, 8.1. */
                inspector?: string | null;
                /** @description Laboratory. Laboratory or company that vouches for the report. */
                laboratory?: string | null;
                /** @description Customer. For whom the test was made. */
                customer?: string | null;
                /** @description Purpose. Acceptance, reverification, compensation, … */
                purpose?: string | null;
                /**
                 * @description Test cycle. Standard test cycle (Figure 1), step cycle (Annex B), pilgrim, unidirectional or user-defined. ISO 230-2:2014, 5.3.2.
                 * @enum {unknown}
                 */
                cycle?: "standard" | "step" | "pilgrim" | "unidirectional" | "user-defined" | null;
                /** @description Feed speed. Feed speed between targets. Unit mm/min; °/min on a rotary axis. ISO 230-2:2014, 8.1. */
                feed?: number | null;
                /** @description Dwell time at each target. Dwell time at each target position. Unit s. ISO 230-2:2014, 8.1. */
                dwell_s?: number | null;
                /** @description Warm-up operation. How long or how often the axis was moved beforehand, and how fast. ISO 230-2:2014, 8.1. */
                warm_up?: string | null;
                /** @description Position of axes not under test. Such as 'Y = 300 mm; Z = 350 mm; C = 0°'. ISO 230-2:2014, 8.1. */
                axes_not_under_test?: string | null;
                /** @description Offset to tool reference X/Y/Z. Three numbers. Unit mm. ISO 230-2:2014, 8.1. */
                tool_offset_mm?: number[] | null;
                /** @description Offset to workpiece reference X/Y/Z. Three numbers. Unit mm. ISO 230-2:2014, 8.1. */
                workpiece_offset_mm?: number[] | null;
                /** @description Air or oil shower. When applied. ISO 230-2:2014, 8.1. */
                air_or_oil_shower?: string | null;
                /** @description Tell the smaller of R↑ and R↓. Whether min(R↑, R↓), as lists of export controls use it, is told for information; not a parameter of the standard. */
                smaller_repeatability?: boolean | null;
                /** @description Comment. Anything else. */
                comment?: string | null;
            } | null;
            machine?: {
                /** @description Machine name. Maker and model of the machine. ISO 230-2:2014, 8.1. */
                name?: string | null;
                /** @description Machine type. Horizontal or vertical spindle and kind of machine. ISO 230-2:2014, 8.1. */
                type?: string | null;
                /** @description Machine serial number. Serial number of the machine. */
                serial_number?: string | null;
                /** @description Travels of the coordinate axes. Travels of all coordinate axes, as text. ISO 230-2:2014, 8.1. */
                axes_travel?: string | null;
                /** @description Location. Where the machine stands. */
                location?: string | null;
            } | null;
            axis?: {
                /** @description Axis under test. Letter or name of the axis. ISO 230-2:2014, 8.1. */
                name?: string | null;
                /**
                 * @description Kind of axis. Linear (mm, µm) or rotary (degrees, seconds of arc). ISO 230-2:2014, 1.
                 * @enum {unknown}
                 */
                kind?: "linear" | "rotary" | null;
                /** @description Axis travel, from. Lower end of the axis travel. Unit mm; ° on a rotary axis. ISO 230-2:2014, 3.1. */
                travel_begin?: number | null;
                /** @description Axis travel, to. Upper end of the axis travel. Unit mm; ° on a rotary axis. ISO 230-2:2014, 3.1. */
                travel_end?: number | null;
                /** @description Measurement line or orientation. Linear: where the line lies relative to the other axes. Rotary: where the axis lies and how it points. ISO 230-2:2014, 8.1. */
                measurement_line?: string | null;
                /** @description Type of scale. Ball screw and rotary encoder, linear scale, … ISO 230-2:2014, 8.1. */
                scale_type?: string | null;
                /** @description Expansion coefficient of the scale. Coefficient of thermal expansion of the machine scale. Unit µm/(m·°C). ISO 230-2:2014, 8.1. */
                scale_expansion_um_per_m_C?: number | null;
                /** @description Compensation used. Built-in compensation during the test, such as 'reversal and leadscrew'; 'none' is an answer. ISO 230-2:2014, 8.1. */
                compensation?: string | null;
                /** @description Sampling points of the compensation. Positions of the compensation table, which the targets must not repeat. Unit mm; ° on a rotary axis. ISO 230-2:2014, 5.2. */
                compensation_points?: number[] | null;
                /** @description Expected period of a periodic error. Pitch of the screw or of the scale, when known. Unit mm; ° on a rotary axis. ISO 230-2:2014, 5.2. */
                expected_period?: number | null;
                /** @description Line in space, origin X/Y/Z. Where X, Y and Z stand at position 0 of a line that is driven in space, such as a diagonal. Unit mm. */
                line_origin_mm?: number[] | null;
                /** @description Line in space, direction X/Y/Z. Where position grows along the line, of any length: 1 1 0 is the diagonal of X and Y. Several axes that move at once make a test after ISO 230-6. */
                line_direction?: number[] | null;
            } | null;
            /** @description Test equipment. Every component of the measuring instrument: laser head, optics, sensors. ISO 230-2:2014, 8.1. */
            equipment?: {
                /** @description Component. */
                role?: string | null;
                /** @description Manufacturer. */
                manufacturer?: string | null;
                /** @description Type. */
                type?: string | null;
                /** @description Serial number. */
                serial_number?: string | null;
                /** @description Certificate. */
                certificate?: string | null;
                /** @description Calibrated on. */
                calibrated_on?: string | null;
                /** @description Calibration due. */
                calibration_due?: string | null;
            }[] | null;
            nde?: {
                /** @description NDE correction applied. Whether nominal differential expansion was corrected mathematically. ISO 230-2:2014, 8.1. */
                applied?: boolean | null;
                /** @description Expansion coefficient used, machine. Coefficient used for the machine's expansion. Unit µm/(m·°C). ISO 230-2:2014, 8.1. */
                machine_expansion_um_per_m_C?: number | null;
                /** @description Expansion coefficient used, equipment. Coefficient used for the measuring equipment's expansion. Unit µm/(m·°C). ISO 230-2:2014, 8.1. */
                equipment_expansion_um_per_m_C?: number | null;
                /** @description Compensation routine. How often the correction is updated. ISO 230-2:2014, 8.1. */
                routine?: string | null;
                /** @description Datum of the instrument. Position at which the instrument was set to zero, where a correction by this program is none; the first target when not given. Unit mm; ° on a rotary axis. */
                datum?: number | null;
            } | null;
            /** @description Temperature sensors. Sensors with their readings at the start and the end; role is machine, equipment or air. ISO 230-2:2014, 8.1. */
            sensors?: {
                /** @description Sensor. */
                role?: string | null;
                /** @description Location. */
                location?: string | null;
                /** @description Start. Unit °C. */
                start_C?: number | null;
                /** @description End. Unit °C. */
                end_C?: number | null;
            }[] | null;
            environment?: {
                /** @description Air temperature at the start. Near the laser beam. Unit °C. ISO 230-2:2014, 8.1. */
                air_temperature_start_C?: number | null;
                /** @description Air temperature at the end. Near the laser beam. Unit °C. ISO 230-2:2014, 8.1. */
                air_temperature_end_C?: number | null;
                /** @description Air pressure at the start. Near the laser beam. Unit kPa. ISO 230-2:2014, 8.1. */
                air_pressure_start_kPa?: number | null;
                /** @description Air pressure at the end. Near the laser beam. Unit kPa. ISO 230-2:2014, 8.1. */
                air_pressure_end_kPa?: number | null;
                /** @description Air humidity at the start. Near the laser beam. Unit %. ISO 230-2:2014, 8.1. */
                air_humidity_start_percent?: number | null;
                /** @description Air humidity at the end. Near the laser beam. Unit %. ISO 230-2:2014, 8.1. */
                air_humidity_end_percent?: number | null;
                /** @description Lowest temperature of the air. During the whole test; what a log of temperatures tells takes its place. Unit °C. ISO 230-2:2014, 7. */
                lowest_C?: number | null;
                /** @description Highest temperature of the air. During the whole test; what a log of temperatures tells takes its place. Unit °C. ISO 230-2:2014, 7. */
                highest_C?: number | null;
                /** @description Change per hour, during the test. The largest, of the air; what a log of temperatures tells takes its place. Unit °C/h. ISO 230-2:2014, 4.1. */
                rate_C_per_h?: number | null;
                /** @description Change per hour, in the twelve hours before. The largest, of the air; what a log of temperatures tells takes its place. Unit °C/h. ISO 230-2:2014, 4.1. */
                rate_before_C_per_h?: number | null;
                /** @description Gradient over the machine. During the whole test; what a log of temperatures tells takes its place. Unit °C. ISO 230-2:2014, 4.1. */
                machine_gradient_C?: number | null;
                /** @description Time of soaking. How long machine and measuring equipment stood in the surroundings before the test. Unit h. ISO 230-2:2014, 4.1. */
                soaked_h?: number | null;
                /** @description Agreed lowest temperature. Limit between the parties. Unit °C. ISO 230-2:2014, 7. */
                agreed_lowest_C?: number | null;
                /** @description Agreed highest temperature. Limit between the parties. Unit °C. ISO 230-2:2014, 7. */
                agreed_highest_C?: number | null;
                /** @description Agreed change per hour. Limit between the parties, in the twelve hours before the test and during it. Unit °C/h. ISO 230-2:2014, 4.1. */
                agreed_rate_C_per_h?: number | null;
                /** @description Agreed gradient over the machine. Limit between the parties. Unit °C. ISO 230-2:2014, 4.1. */
                agreed_gradient_C?: number | null;
            } | null;
            instrument?: {
                /** @description Vacuum wavelength. Of the laser, for the correction of readings for the refractive index of air; 632.9909 when not given. Unit nm. */
                vacuum_wavelength_nm?: number | null;
                /** @description Refractive index assumed by the instrument. 1 when the instrument shows lengths in vacuum wavelengths; wanted for the correction for the air. */
                refractive_index?: number | null;
                /** @description Dead path. Distance between the fixed and the moving optics at the datum that the instrument does not compensate. Unit mm. */
                dead_path_mm?: number | null;
                /** @description Carbon dioxide in the air. By volume; 450 when not given. Unit ppm. */
                air_co2_ppm?: number | null;
                /** @description Gain of the sensor. True change of position per change shown; applied to the readings only on request. */
                gain?: number | null;
                /** @description Sign reversed. Whether the instrument counts up when the axis moves in the negative direction. */
                sign_reversed?: boolean | null;
            } | null;
            artefact?: {
                /** @description Artefact. Ball array or step gauge. ISO 230-2:2014, Annex D. */
                type?: string | null;
                /** @description Serial number of the artefact. Serial number of the artefact. ISO 230-2:2014, Annex D. */
                serial_number?: string | null;
                /** @description Calibration certificate. Number and date of the certificate. ISO 230-2:2014, Annex D. */
                certificate?: string | null;
                /** @description Calibrated positions. Of the balls or faces at 20 °C, one per target and in their order; the readings are then positions that the machine indicated at them. Unit mm. ISO 230-2:2014, Annex D. */
                calibrated_positions?: number[] | null;
                /** @description Calibration uncertainty of the artefact. U, k = 2, of every calibrated position. Unit µm; ″ on a rotary axis. ISO 230-2:2014, Annex D. */
                calibration_uncertainty?: number | null;
                /** @description Calibration uncertainty of the artefact, by length. U, k = 2, in proportion to the length. Unit µm/m. ISO 230-2:2014, Annex D. */
                calibration_uncertainty_um_per_m?: number | null;
                /**
                 * @description Sum of both parts of the artefact's calibration uncertainty. How a constant part and one per metre make U: a + b·L (when not given), or the root of their squares. ISO 230-2:2014, Annex D.
                 * @enum {unknown}
                 */
                calibration_sum?: "linear" | "quadratic" | null;
                /** @description Probing uncertainty. U, k = 2, of one probing. Unit µm; ″ on a rotary axis. ISO 230-2:2014, Annex D. */
                probing_uncertainty?: number | null;
            } | null;
            tolerance?: {
                /** @description Tolerance of A. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                A?: number | null;
                /** @description Tolerance of A↑. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                A_up?: number | null;
                /** @description Tolerance of A↓. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                A_down?: number | null;
                /** @description Tolerance of E. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                E?: number | null;
                /** @description Tolerance of E↑. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                E_up?: number | null;
                /** @description Tolerance of E↓. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                E_down?: number | null;
                /** @description Tolerance of M. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                M?: number | null;
                /** @description Tolerance of R. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                R?: number | null;
                /** @description Tolerance of R↑. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                R_up?: number | null;
                /** @description Tolerance of R↓. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                R_down?: number | null;
                /** @description Tolerance of B. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                B?: number | null;
                /** @description Tolerance of |B̄|. Upper limit. Unit µm; ″ on a rotary axis. ISO 230-2:2014, 8.2. */
                B_mean?: number | null;
                /** @description Tolerance table. Which of the names in a file of tolerance tables. */
                table?: string | null;
                /**
                 * @description Decision rule. How the uncertainty counts in a verdict: simple acceptance, ISO 14253-1, or a guard band of a given width.
                 * @enum {unknown}
                 */
                rule?: "simple" | "iso14253-1" | "guard-band" | null;
                /** @description Guard band. Its width, for the rule guard-band. Unit µm; ″ on a rotary axis. */
                guard_band?: number | null;
            } | null;
            uncertainty?: {
                /** @description Measurement length L. The measured travel when not given. Unit mm. Linear axes only. ISO 230-2:2014, A.2.2. */
                length_mm?: number | null;
                /** @description Calibration uncertainty of the device (k = 2). U of the calibration certificate. Unit µm; ″ on a rotary axis. ISO 230-2:2014, A.1. */
                device_calibration?: number | null;
                /** @description Calibration uncertainty of the device (k = 2). U of the calibration certificate per metre. Unit µm/m. Linear axes only. ISO 230-2:2014, A.2. */
                device_calibration_um_per_m?: number | null;
                /**
                 * @description Sum of both parts of the calibration uncertainty. How a constant part and one per metre make U: a + b·L (when not given), or the root of their squares.
                 * @enum {unknown}
                 */
                device_calibration_sum?: "linear" | "quadratic" | null;
                /** @description Error range of the device. Full range stated by the manufacturer. Unit µm/m. Linear axes only. ISO 230-2:2014, A.3. */
                device_error_range_um_per_m?: number | null;
                /** @description Misalignment. Of the measuring device to the axis. Unit mm. Linear axes only. ISO 230-2:2014, A.4. */
                misalignment_mm?: number | null;
                /** @description Expansion coefficient of the machine. That of the scale when not given, else 12. Unit µm/(m·°C). Linear axes only. ISO 230-2:2014, A.5. */
                machine_expansion_um_per_m_C?: number | null;
                /** @description Range of the temperature measurement, machine. Full range R(θ): 1 °C is ±0.5 °C. Unit °C. Linear axes only. ISO 230-2:2014, A.5. */
                machine_temperature_range_C?: number | null;
                /** @description Largest difference to 20 °C, machine. From the machine's temperature sensors when not given. Unit °C. Linear axes only. ISO 230-2:2014, A.7. */
                machine_temperature_difference_C?: number | null;
                /** @description Range of the expansion coefficient, machine. Full range R(α); 2 when not given. Unit µm/(m·°C). Linear axes only. ISO 230-2:2014, A.7. */
                machine_expansion_range_um_per_m_C?: number | null;
                /** @description Expansion coefficient of the device. Only when the device's statement does not include temperature. Unit µm/(m·°C). Linear axes only. ISO 230-2:2014, A.6. */
                device_expansion_um_per_m_C?: number | null;
                /** @description Range of the temperature measurement, device. Full range R(θ). Unit °C. Linear axes only. ISO 230-2:2014, A.6. */
                device_temperature_range_C?: number | null;
                /** @description Largest difference to 20 °C, device. Only when the device's statement does not include temperature. Unit °C. Linear axes only. ISO 230-2:2014, A.8. */
                device_temperature_difference_C?: number | null;
                /** @description Range of the expansion coefficient, device. Full range R(α). Unit µm/(m·°C). Linear axes only. ISO 230-2:2014, A.8. */
                device_expansion_range_um_per_m_C?: number | null;
                /** @description Environmental variation error. Range E_VE of the drift test. Unit µm; ″ on a rotary axis. ISO 230-2:2014, A.9. */
                environmental_variation?: number | null;
                /** @description Resolution of the axis. Smallest step of the axis scale. Unit µm; ″ on a rotary axis. */
                axis_resolution?: number | null;
                /** @description Resolution of the measuring instrument. Smallest step of the readings. Unit µm; ″ on a rotary axis. */
                instrument_resolution?: number | null;
                /** @description Sensitivity of the instrument to its environment. Standard uncertainty K of the instrument's own compensation, per metre and per °C away from 20 °C. Unit µm/(m·°C). Linear axes only. */
                environment_sensitivity_um_per_m_C?: number | null;
                /** @description Difference of the air to 20 °C. From the air temperatures when not given. Unit °C. Linear axes only. */
                environment_temperature_difference_C?: number | null;
                /** @description Largest angle of misalignment. Between measuring instrument and axis. From the misalignment over L when not given. Unit °. Linear axes only. */
                alignment_angle_deg?: number | null;
                /** @description Correlation between ↑ and ↓. Between the errors of both directions at one target; 1 when not given. */
                up_down_correlation?: number | null;
                /** @description Drift from run to run. Standard uncertainty of a shift that all readings of one run have in common. Unit µm; ″ on a rotary axis. */
                run_drift?: number | null;
                /**
                 * @description Measurand. What is uncertain: what perfect instruments would have found in this test (when not given), or what this machine does in the long run, of which the approaches are a sample.
                 * @enum {unknown}
                 */
                measurand?: "this-test" | "this-machine" | null;
                /**
                 * @description Method of record. Whose uncertainty stands with every result and decides. When not given: Monte Carlo where it was asked for, else Annex A, else the GUM.
                 * @enum {unknown}
                 */
                method?: "annex-a" | "gum" | "monte-carlo" | null;
                /**
                 * @description Kind of environmental variation. How E_VE moves the readings: from each to the next (white), slowly (drift), in steps that add up (random-walk). When not given it is unknown: what any of these would do counts, as far as the readings allow it.
                 * @enum {unknown}
                 */
                environment_kind?: "unknown" | "white" | "drift" | "random-walk" | null;
                /** @description Recording of the environmental variation. Readings at standstill, equally far apart in time; they take the place of E_VE. Unit µm; ″ on a rotary axis. ISO 230-2:2014, A.2.5. */
                drift_recording?: number[] | null;
                /** @description Time between two of its readings. Of the recording of the environmental variation. Unit s. ISO 230-2:2014, A.2.5. */
                drift_interval_s?: number | null;
                /** @description Distributions of inputs. Each replaces that of a named input, as in 'machine_temperature | triangular 1.5 2.5', or adds an own input to scale, target, run or reading, as in 'scale:optics | normal 0 0.2'. */
                distributions?: {
                    /** @description Input. */
                    input?: string | null;
                    /** @description Distribution. */
                    distribution?: string | null;
                }[] | null;
            } | null;
            tracking?: {
                /** @description Tracking interferometer, position along the line. Position of the point of the line that is next to the station. Unit mm. Linear axes only. */
                station_position?: number | null;
                /** @description Tracking interferometer, uncertainty across the line. Standard uncertainties of the station in the two principal directions across the line. Unit mm. Linear axes only. */
                station_uncertainty_mm?: number[] | null;
            } | null;
        };
        /**
         * @description How an uncertainty was found; chosen by the field uncertainty.method.
         * @enum {string}
         */
        Method: "annex_a" | "gum" | "monte_carlo";
        /** @description JCGM 101: mean, standard uncertainty and coverage intervals. */
        MonteCarloOutput: {
            value: number;
            mean: number;
            u: number;
            bias: number;
            /** @description The interval that is stated holds for every hypothesis about the noise. */
            low: number;
            high: number;
            /** @description Key of the hypothesis that gives this end. */
            low_from?: string;
            high_from?: string;
            /** @description Why no interval is stated; absent where one is. */
            refusal?: string;
            /** @description By the keys of the hypotheses. */
            by_hypothesis: {
                [key: string]: {
                    mean: number;
                    u: number;
                    symmetric: components["schemas"]["Interval"];
                };
            };
            symmetric: components["schemas"]["Interval"];
            shortest: components["schemas"]["Interval"];
            /** @description Numerical tolerance that was asked for. */
            delta: number;
            stable: boolean;
            mean_error: number;
            u_error: number;
            symmetric_error: components["schemas"]["Interval"];
            histogram: {
                lower: number;
                width: number;
                counts: number[];
            };
        };
        MonteCarloOutputs: {
            A: components["schemas"]["MonteCarloOutput"] | null;
            A_up: components["schemas"]["MonteCarloOutput"] | null;
            A_down: components["schemas"]["MonteCarloOutput"] | null;
            E: components["schemas"]["MonteCarloOutput"] | null;
            E_up: components["schemas"]["MonteCarloOutput"] | null;
            E_down: components["schemas"]["MonteCarloOutput"] | null;
            M: components["schemas"]["MonteCarloOutput"] | null;
            R: components["schemas"]["MonteCarloOutput"] | null;
            R_up: components["schemas"]["MonteCarloOutput"] | null;
            R_down: components["schemas"]["MonteCarloOutput"] | null;
            B: components["schemas"]["MonteCarloOutput"] | null;
            B_mean: components["schemas"]["MonteCarloOutput"] | null;
        };
        MonteCarloRun: {
            measurand: components["schemas"]["Measurand"];
            type_a: ("pooled" | "t-scaled" | "resampled") | null;
            trials: number;
            adaptive: boolean;
            stable: boolean;
            seed: components["schemas"]["Seed"];
            coverage: number;
            /** @description About the noise. */
            hypotheses: {
                key: string;
                title: string;
                refuted: boolean;
                p: number | null;
                reason: string;
            }[];
            inputs: {
                key: string;
                symbol: string;
                title: string;
                source: string;
                /** @enum {string} */
                effect: "machine_expansion" | "machine_temperature" | "device_expansion" | "device_temperature" | "alignment" | "station" | "scale" | "displacement" | "target" | "target_direction" | "run" | "reading";
                distribution: string;
                u: number | null;
                unit: string;
                note?: string;
            }[];
            contributions: {
                key: string;
                title: string;
                u: components["schemas"]["ParameterNumbers"];
            }[];
            /** @description The mean deviations at the targets, of at most 120; empty where a parameter is refused. */
            positions?: {
                target: number;
                up: components["schemas"]["DrawnMean"] | null;
                down: components["schemas"]["DrawnMean"] | null;
                mean: components["schemas"]["DrawnMean"] | null;
            }[];
            /** @description For each hypothesis about the noise. */
            position_trials?: number;
            notes: string[];
        };
        /** @description Lists of numbers, one for each position. */
        MotionCourse: {
            mean: number[];
            /** @description About its own line. */
            residual: number[];
            /** @description Over the runs. */
            s?: (number | null)[];
        };
        MotionEstimate: {
            value: number;
            /** @description Standard uncertainty. */
            u: number | null;
            k: number | null;
            /** @description About 95 %. */
            U: number | null;
            /** @enum {string|null} */
            scatter?: "runs" | "noise" | "residuals" | null;
            u_scatter?: number | null;
            degrees_of_freedom?: number | null;
            u_instrument?: number | null;
        };
        /** @description Of all samples those that a screen can show, the highest and the lowest among them. */
        DynamicCurve: {
            time_s: number[];
            value: number[];
        };
        DynamicExtreme: {
            value: number;
            time_s: number;
            position: number;
        };
        DynamicExtremes: {
            highest: components["schemas"]["DynamicExtreme"];
            lowest: components["schemas"]["DynamicExtreme"];
        };
        /** @description Members of the query `options`; what is left out is as `axiometry dynamic` has it. */
        DynamicOptions: {
            /** @enum {string} */
            kind?: "linear" | "rotary";
            /** @description Layout of the recording instead of recognising it. */
            stream?: string;
            /** @description Samples per second, for layouts that do not tell it. */
            rate_hz?: number;
            /** @description mm or ° per count, for layouts of counts. */
            units_per_count?: number;
            /** @description Which axis or column of a recording of several. */
            stream_axis?: number;
            /** @description Leaves out what is no sample; always so of a file whose name ends in `.raw`. */
            skip_damaged?: boolean;
            /** @description The instrument counts up when the axis moves down. */
            reverse?: boolean;
            /** @description Feed that was asked for, mm or ° per minute. */
            feed_per_min?: number;
            /** @description Time over which velocity and acceleration are taken. */
            window_s?: number;
            /** @description How far the velocity of even motion may be from its median. */
            even_percent?: number;
            /** @description Only from this time of the recording on. */
            from_s?: number;
            /** @description Only up to this time. */
            to_s?: number;
        };
        /** @description As `axiometry dynamic` writes it with `--json`; docs/results.md explains it. Texts in the language of the request. */
        DynamicResult: {
            /** @constant */
            result: "dynamic";
            /** @enum {string} */
            unit: "mm" | "°";
            /** @enum {string} */
            deviation_unit: "um" | "arcsec";
            samples: number;
            rate_hz: number;
            begin_s: number;
            window_s: number;
            noise: {
                position: number;
                velocity_per_s: number;
                acceleration_per_s2: number;
            };
            velocity_per_s: components["schemas"]["DynamicExtremes"];
            acceleration_per_s2: components["schemas"]["DynamicExtremes"];
            feed_per_min: number | null;
            uniform_share: number;
            uniform: components["schemas"]["DynamicStretch"][];
            spectrum: components["schemas"]["DynamicSpectrum"];
            remarks: string[];
            source: {
                file: string;
                sha256: string;
                format: string;
            };
            program: components["schemas"]["Program"];
            /** @description For a screen; not in the report as JSON. */
            curves?: {
                position: components["schemas"]["DynamicCurve"];
                velocity_per_s: components["schemas"]["DynamicCurve"];
                acceleration_per_s2: components["schemas"]["DynamicCurve"];
                /** @description Of the longest stretches of even motion, eight at most, in order of time: what strays from their lines over the position. */
                straying: {
                    begin_s: number;
                    position: number[];
                    value: number[];
                }[];
                spectrum: {
                    frequency_hz: number[];
                    value: number[];
                };
            };
        };
        DynamicSpectrum: {
            /** @enum {string} */
            of: "longest_stretch" | "recording";
            begin_s: number;
            end_s: number;
            /** @constant */
            window: "hann";
            step_hz: number;
            /** @description Nearer frequencies cannot be told apart. */
            resolution_hz: number;
            floor: number;
            threshold: number;
            /** @description Lower ones than those listed. */
            peaks_more: number;
            /** @description What a drift or higher ones may have left beside themselves. */
            peaks_beside: number;
            peaks: {
                frequency_hz: number;
                amplitude: number;
                /** @description Along the axis; null where it did not move evenly. */
                period: number | null;
            }[];
        };
        /** @description A stretch of even motion. */
        DynamicStretch: {
            /** @enum {string} */
            direction: "up" | "down";
            begin_s: number;
            end_s: number;
            from: number;
            to: number;
            velocity_per_s: number;
            /** @description null without a feed that was asked for. */
            feed_error_percent: number | null;
            velocity_standard_deviation_per_s: number;
            velocity_range_per_s: number;
            /** @description From the straight line of position over time. */
            deviation_range: number;
            deviation_rms: number;
            acceleration_rms_per_s2: number;
        };
        MotionForm: {
            /**
             * @description Without it straightness or angles, as the readings are; of two files of straightness squareness.
             * @enum {string}
             */
            kind?: "straightness" | "angles" | "squareness";
            /** @description JSON: MotionOptions. */
            options?: string;
            /**
             * Format: binary
             * @description CSV: position_mm, run, direction, straightness_um or angle_urad.
             */
            readings: string;
            /**
             * Format: binary
             * @description A second file; further ones are readings-3 and so on.
             */
            "readings-2"?: string;
            /**
             * Format: binary
             * @description After which readings alone were taken: one column, a row for each approach. Of a squareness that of the first line.
             */
            plan?: string;
            /**
             * Format: binary
             * @description Of a squareness, that of the second line.
             */
            "plan-2"?: string;
        };
        /** @description One file, evaluated; docs/results.md explains it. */
        MotionOfFile: {
            /** @description EYX, EAX. */
            error: string | null;
            /** @description Which way its readings were positive: +Y, -Y; of - all numbers are turned. */
            read_positive: string | null;
            /** @enum {string} */
            unit: "um" | "urad" | "arcsec";
            /** @enum {string} */
            reference: "least-squares" | "end-points" | "none";
            runs: number;
            /** @description Expanded uncertainty (k = 2) as stated: constant part and part per metre of the unit. */
            instrument?: {
                U_constant: number;
                U_per_m: number;
            } | null;
            courses: {
                /** @enum {string} */
                course: "up" | "down" | "mean";
                range: components["schemas"]["MotionEstimate"];
                highest_mm: number;
                lowest_mm: number;
                slope_per_m?: components["schemas"]["MotionEstimate"];
                theta_arcsec?: number;
                intercept?: components["schemas"]["MotionEstimate"];
            }[];
            range_both: components["schemas"]["MotionEstimate"] | null;
            reversal: components["schemas"]["MotionEstimate"] | null;
            reversal_mean: number | null;
            repeatability_up: number | null;
            repeatability_down: number | null;
            repeatability: number | null;
            positions: {
                position_mm: number[];
                up?: components["schemas"]["MotionCourse"];
                down?: components["schemas"]["MotionCourse"];
                mean?: components["schemas"]["MotionCourse"];
                reversal?: (number | null)[];
                repeatability?: (number | null)[];
            };
            remarks: string[];
            metadata: components["schemas"]["Metadata"];
            source: {
                file: string;
                sha256: components["schemas"]["Sha256"];
            };
        };
        /** @description As `axiometry straightness`, `angles` and `squareness` write it with `--json`; docs/results.md explains it. Texts in the language of the request. */
        MotionResult: {
            /** @description In a report of what was withdrawn: true; else left out. */
            withdrawn?: boolean;
            /** @enum {string} */
            result: "straightness" | "angles" | "squareness";
            straightness?: components["schemas"]["MotionOfFile"];
            angles?: components["schemas"]["MotionOfFile"][];
            lines?: components["schemas"]["MotionOfFile"][];
            theta_1_arcsec?: components["schemas"]["MotionEstimate"];
            theta_2_arcsec?: components["schemas"]["MotionEstimate"];
            squareness_arcsec?: components["schemas"]["MotionEstimate"];
            /** @description Of a squareness: which course of the first line and which of the second it is taken from. */
            courses?: ("up" | "down" | "mean")[];
            in_axes?: boolean;
            location_error?: {
                /** @enum {string} */
                name: "C0Y" | "B0Z" | "A0Z";
                urad: components["schemas"]["MotionEstimate"];
            } | null;
            square_error_arcsec?: number | null;
            square_uncertainty_arcsec?: number | null;
            abbe?: {
                offset_mm: number[];
                /** @description By the name of the error; null where an angle is missing. */
                change_um: {
                    [key: string]: number[] | null;
                };
                /** @description The same of positive approaches, where all angles have both directions. */
                change_up_um?: {
                    [key: string]: number[];
                };
                /** @description The same of negative approaches. */
                change_down_um?: {
                    [key: string]: number[];
                };
                /**
                 * @description Of change_um: the mean of both directions where all angles have both. Null where no angle is enough.
                 * @enum {unknown}
                 */
                course?: "up" | "down" | "mean" | null;
                /** @description By the name of the error, what was not measured. */
                missing: {
                    [key: string]: string;
                };
            } | null;
            remarks?: string[];
            program: components["schemas"]["Program"];
        };
        Named: {
            id: string;
            title: string;
        };
        /** @description An object of which nothing is read. */
        Nothing: {
            [key: string]: unknown;
        };
        /** @description How a test is evaluated, beside its metadata. */
        Options: {
            /** @description Beside Annex A, which is always there. */
            methods: ("gum" | "monte-carlo")[];
            /** @description Of the Monte Carlo method; null: until two digits are stable. */
            trials: number | null;
            seed: components["schemas"]["Seed"];
            /** @description Of intervals: 0.95. */
            coverage: number;
            /** @description As `--correct` takes them: `nde`, `air=ciddor`. */
            corrections: string[];
            temperatures?: components["schemas"]["KeptTemperatures"];
        };
        /**
         * @description Parameter of ISO 230-2:2014, clause 3; `up` and `down` are the directions of approach.
         * @enum {string}
         */
        Parameter: "A" | "A_up" | "A_down" | "E" | "E_up" | "E_down" | "M" | "R" | "R_up" | "R_down" | "B" | "B_mean";
        /** @description Null where the parameter does not exist. */
        ParameterNumbers: {
            A: number | null;
            A_up: number | null;
            A_down: number | null;
            E: number | null;
            E_up: number | null;
            E_down: number | null;
            M: number | null;
            R: number | null;
            R_up: number | null;
            R_down: number | null;
            B: number | null;
            B_mean: number | null;
        };
        /** @description X, Y, Z. */
        Place: number[];
        Plan: components["schemas"]["PlanRow"] & components["schemas"]["PlanDraft"];
        PlanDraft: {
            plan: components["schemas"]["PlanFile"];
            targets: number[];
            duration_s: number;
            findings: components["schemas"]["Finding"][];
            conforming: boolean;
            /** @description The way of the axis. */
            figure_svg: string;
            /** @description Null of a plan that came as a file. */
            request: components["schemas"]["PlanRequest"] | null;
            /** @description The plan itself and its further ones. */
            parts: components["schemas"]["PlanPart"][];
        };
        PlanEdit: {
            title?: string;
            axis?: components["schemas"]["Id"] | null;
        } & (components["schemas"]["PlanSubject"] & components["schemas"]["EditNote"]);
        /** @description A test programme of one machine tool axis: what shall be measured, and in which order. */
        PlanFile: {
            /** @enum {unknown} */
            format?: "axiometry-plan/1" | null;
            /** @description Standard whose terms the plan uses: ISO 230-2:2014, or ISO 230-6:2002 along a diagonal. */
            standard?: string | null;
            /** @description Clause that describes the test: 5.3.2 to 5.3.5, Annex B or Annex C; absent when none does. */
            clause?: string | null;
            /** @description Another rule whose cycle the plan keeps to as well, by the name that `plan --standard` takes. */
            rule?: string | null;
            /** @description Which test of several this is. */
            title?: string | null;
            /** @description Name of the machine, for the printed sheet and for comments in part programs. */
            machine?: string | null;
            /** @description Date on which the plan was made, ISO 8601 preferred. */
            date?: string | null;
            axis: {
                /** @description Axis under test. Letter or name of the axis. ISO 230-2:2014, 8.1. */
                name?: string | null;
                /**
                 * @description Kind of axis. Linear (mm, µm) or rotary (degrees, seconds of arc). ISO 230-2:2014, 1.
                 * @enum {unknown}
                 */
                kind: "linear" | "rotary" | null;
                /** @description Axis travel, from. Lower end of the axis travel. Unit mm; ° on a rotary axis. ISO 230-2:2014, 3.1. */
                travel_begin?: number | null;
                /** @description Axis travel, to. Upper end of the axis travel. Unit mm; ° on a rotary axis. ISO 230-2:2014, 3.1. */
                travel_end?: number | null;
                /** @description Measurement line or orientation. Linear: where the line lies relative to the other axes. Rotary: where the axis lies and how it points. ISO 230-2:2014, 8.1. */
                measurement_line?: string | null;
                /** @description Type of scale. Ball screw and rotary encoder, linear scale, … ISO 230-2:2014, 8.1. */
                scale_type?: string | null;
                /** @description Expansion coefficient of the scale. Coefficient of thermal expansion of the machine scale. Unit µm/(m·°C). ISO 230-2:2014, 8.1. */
                scale_expansion_um_per_m_C?: number | null;
                /** @description Compensation used. Built-in compensation during the test, such as 'reversal and leadscrew'; 'none' is an answer. ISO 230-2:2014, 8.1. */
                compensation?: string | null;
                /** @description Sampling points of the compensation. Positions of the compensation table, which the targets must not repeat. Unit mm; ° on a rotary axis. ISO 230-2:2014, 5.2. */
                compensation_points?: number[] | null;
                /** @description Expected period of a periodic error. Pitch of the screw or of the scale, when known. Unit mm; ° on a rotary axis. ISO 230-2:2014, 5.2. */
                expected_period?: number | null;
                /** @description Line in space, origin X/Y/Z. Where X, Y and Z stand at position 0 of a line that is driven in space, such as a diagonal. Unit mm. */
                line_origin_mm?: number[] | null;
                /** @description Line in space, direction X/Y/Z. Where position grows along the line, of any length: 1 1 0 is the diagonal of X and Y. Several axes that move at once make a test after ISO 230-6. */
                line_direction?: number[] | null;
            };
            /** @description What is to be read at each stop, by the names of ISO 230-1: EYX is the straightness of X in the direction of Y, EAX its roll, EXX its positions. Absent or empty: the positions alone. */
            errors?: string[] | null;
            /**
             * @description Order of the approaches (5.3.2, Annex B).
             * @enum {unknown}
             */
            cycle: "standard" | "step" | "pilgrim" | "unidirectional" | "user-defined";
            /** @description Target positions (3.4), mm or degrees; in any order, they are sorted. */
            targets: number[];
            /** @description Approaches to each target from each direction of the cycle (n). */
            runs: number;
            /** @description Distance beyond a target before the direction changes, mm or degrees. */
            overrun: number;
            /** @description Feed speed between targets, mm/min or degrees/min. */
            feed: number;
            /** @description Of the axis, mm/s² or degrees/s², on which durations rest; absent or null: 1000, or 500 of a rotary one. */
            acceleration?: number | null;
            /** @description Time at rest on every target, seconds. */
            dwell_s: number;
            /** @description Movements there and back before the first reading. */
            warm_up_runs?: number;
            /** @description Of the random part of the targets; from 2^53 on as a string. */
            seed?: number | string | null;
            /** @description Where X, Y and Z are driven before the first move on a line in space, points in order. */
            way_in_mm?: number[][] | null;
            /** @description Where X, Y and Z are driven after the last move on a line in space. */
            way_out_mm?: number[][] | null;
            /** @description The approaches of the user-defined cycle, in their order. */
            sequence?: [
                number,
                "up" | "down",
                number
            ][] | null;
            /** @description Tests that belong to this one (5.3.3, 5.3.5); one level only. */
            further?: components["schemas"]["PlanFile"][] | null;
            /** @description What the program says about the plan; ignored when it is read. */
            findings?: {
                /** @description Stable. */
                id?: string;
                clause: string;
                /** @enum {unknown} */
                severity: "departure" | "missing" | "note";
                message: string;
            }[] | null;
            /** @description Estimated duration, seconds; ignored when it is read. */
            duration_s?: number | null;
            /** @description What was asked for; ignored when it is read. */
            request?: Record<string, never> | null;
        };
        PlanList: {
            plans: components["schemas"]["PlanRow"][];
        };
        PlanPart: {
            part: number;
            title: string;
            cycle: components["schemas"]["Cycle"];
            runs: number;
            readings: number;
            targets: number[];
            duration_s: number;
            figure_svg: string;
        };
        /** @description What a plan was made from, with the seed that was drawn: it gives the same plan again. */
        PlanRequest: {
            axis: string;
            kind: components["schemas"]["AxisKind"];
            from: number;
            to: number;
            /** @description null: chosen by the planner. */
            positions: number[] | null;
            /** @description How many; null: what the standard asks for. */
            targets: number | null;
            cycle: components["schemas"]["Cycle"];
            runs: number | null;
            /** @description mm/min or °/min. */
            feed: number | null;
            dwell_s: number | null;
            overrun: number | null;
            seed: number | null;
            /** @description More of `axiometry plan`, by the names of its flags. */
            further: {
                [key: string]: string;
            };
        };
        PlanRow: {
            title: string;
            axis: components["schemas"]["Id"] | null;
        } & components["schemas"]["Entity"];
        /** @description Either a request or a plan. */
        PlanSubject: {
            request?: components["schemas"]["GivenPlanRequest"];
            /** @description A plan's file, or its text, in place of a request. */
            plan?: components["schemas"]["PlanFile"] | string;
        };
        PlanVersions: {
            versions: components["schemas"]["PlanRow"][];
        };
        PositionComponents: {
            approaches: number;
            thermal: number;
            alignment: number;
            axis_resolution: number;
            instrument: number;
            other: number;
        } & components["schemas"]["Expanded"];
        /** @description What clause 3 defines at one target. */
        PositionResult: {
            target: number;
            n_up: number;
            n_down: number;
            mean_up: number | null;
            mean_down: number | null;
            mean: number | null;
            reversal: number | null;
            s_up: number | null;
            s_down: number | null;
            R_up: number | null;
            R_down: number | null;
            R: number | null;
        };
        /** @description A line as a test would show it, less the mean of all targets. */
        PredictedLine: {
            from_mm: number[];
            to_mm: number[];
            systematic_um: number;
            systematic_u_um: number;
            slope_um_per_m: number;
            slope_u_um_per_m: number;
            reversal_um: number | null;
            targets: {
                position_mm: number;
                up_um: number;
                up_u_um: number;
                down_um: number;
                down_u_um: number;
            }[];
        };
        Preview: {
            file: {
                name: string;
                size: number;
                sha256: components["schemas"]["Sha256"];
            };
            format: components["schemas"]["Named"] | null;
            /** @description Why the file is not taken; then there are no tests. */
            refused: components["schemas"]["Problem"] | null;
            /**
             * @description What a refused file is instead of a test: see `/api/dynamic`, `/api/motions` and `/api/plans`; temperatures belong to a test.
             * @enum {string|null}
             */
            instead: "recording" | "error-motion" | "plan" | "temperatures" | null;
            tests: components["schemas"]["PreviewedTest"][];
            /** @description Tests with these very bytes. */
            same_content: components["schemas"]["Id"][];
            /** @description Of a file that is refused but holds a table of numbers, and of one read after a guess or a profile. */
            table: components["schemas"]["AskedTable"] | null;
        };
        PreviewedTest: {
            /** @description In a file of many; else empty. */
            name: string;
            axis: string;
            kind: components["schemas"]["AxisKind"];
            machine: string;
            measured_on: string;
            targets: number;
            runs: number;
            readings: number;
            first: number;
            last: number;
            unit: components["schemas"]["Unit"];
            /** @description Of the first eight. */
            evaluated: components["schemas"]["Evaluated"] | null;
        };
        Problem: {
            kind: components["schemas"]["ErrorKind"];
            /** @description What was found and what was expected, in the language of the request. */
            message: string;
            /** @description The file that is wrong. */
            file: string | null;
            /** @description Counted from 1. */
            line: number | null;
            /** @description Counted from 1, in bytes. */
            column: number | null;
        };
        Program: {
            name: string;
            version: string;
        };
        ProgramRequest: {
            /** @description Of the vocabulary. */
            dialect: string;
            /** @description By the names of the query of `/api/plans/{id}/program`. */
            options?: {
                [key: string]: string | number | boolean;
            };
        } & components["schemas"]["PlanSubject"];
        /** @description Deviations as they were read: a row for each target, a column for each run, null where there is none. */
        Readings: {
            /** @description mm or °. */
            targets: number[];
            up: (number | null)[][];
            down: (number | null)[][];
            /** @description Before corrections, where there were any. */
            as_measured: {
                up: (number | null)[][];
                down: (number | null)[][];
            } | null;
        };
        Reason: {
            reason?: string;
        };
        /** @description In place of what was kept, where the server has no memory left to show it; id and version are null where they are not known. */
        Receipt: {
            /** @constant */
            kept: true;
            id: components["schemas"]["Id"] | null;
            version: number | null;
            message: string;
        };
        Received: {
            /** @description Of the first test in the file. */
            id: components["schemas"]["Id"];
            version: number;
            tests: {
                id: components["schemas"]["Id"];
                version: number;
                title: string;
                /** @description Tests of other files with the very bytes of this test's file, of before or of this upload. */
                same_content: components["schemas"]["Id"][];
                /** @description What became of the machine that it states: that it took over a serial number, or that several are called so. */
                remarks: string[];
            }[];
            /** @description Tests of before with the very bytes of any of the files. */
            same_content: components["schemas"]["Id"][];
        } & components["schemas"]["Evaluated"];
        /** @description A thing of the archive by its number, with its name. */
        Reference: {
            id: components["schemas"]["Id"];
            name: string;
        };
        /** @description A limit of the same parameter that another one has taken the place of. */
        ReplacedLimit: {
            limit: number;
            source: components["schemas"]["LimitSource"];
        };
        /** @description A statement about the uncertainty, used or not, or what follows where none was made. */
        ResolvedInput: {
            key: string;
            symbol: string;
            title: string;
            value: number | string;
            unit: string;
            /** @enum {string} */
            origin: "instrument" | "file" | "entered" | "flag" | "sensors" | "air" | "nde-correction" | "scale" | "measured-travel" | "misalignment" | "alignment-angle" | "assumed";
            /** @description The origin in the language of the request. */
            origin_title: string;
            instrument?: string;
            /** @enum {string} */
            use: "none" | "all" | "annex-a" | "gum-and-monte-carlo";
            /** @description Use and reason in the language of the request. */
            use_title: string;
            reason?: string;
        };
        ResultSource: {
            file: string;
            /** @description Of a file of many. */
            test?: string;
            sha256: components["schemas"]["Sha256"] | null;
            format: string;
        };
        /** @description As `axiometry evaluate --json` writes it; docs/results.md explains every key. A version that an older program has kept is as that one wrote it. */
        Result: {
            standard: string;
            axis: {
                name: string;
                kind: components["schemas"]["AxisKind"];
            };
            unit: components["schemas"]["Unit"];
            /** @description Whether no finding is a departure; what may be claimed stands in claims. */
            conforming: boolean;
            claims: components["schemas"]["Claim"][];
            /** @description Words that must stand wherever the results do. */
            label?: string;
            parameters: components["schemas"]["ParameterNumbers"];
            /** @description Of each parameter that exists, the symbol that names the axis too (8.2.4), "E_XX,A↑"; absent where the axis has none. */
            symbols?: {
                [key: string]: string;
            };
            uncertainty: components["schemas"]["Uncertainty"];
            /** @description Of all limits together. */
            verdict?: components["schemas"]["Judged"];
            tolerances?: components["schemas"]["Judgement"][];
            /** @description Which row of a table the limits are of. */
            tolerance_table?: {
                file: string;
                sha256: components["schemas"]["Sha256"];
                name: string;
                travel_up_to: number | null;
            };
            /** @description What was asked for beside the parameters of the standard. */
            information?: {
                smaller_repeatability: {
                    value: number;
                    /** @enum {string} */
                    of: "R_up" | "R_down";
                    remark: string;
                };
            };
            positions: components["schemas"]["PositionResult"][];
            environment?: components["schemas"]["Surroundings"];
            drift: components["schemas"]["Drift"] | null;
            findings: components["schemas"]["Finding"][];
            metadata: components["schemas"]["Metadata"];
            source: components["schemas"]["ResultSource"];
            corrections?: components["schemas"]["AppliedCorrection"][];
            expansion_correction?: components["schemas"]["ExpansionCorrection"];
            /** @description After corrections, where there were any. */
            readings?: {
                target: number;
                direction: components["schemas"]["Direction"];
                run: number;
                deviation: number;
                as_measured: number | null;
            }[];
            program: components["schemas"]["Program"];
            /** @description Of `axiometry evaluate --verify`. */
            verification?: {
                figures: number;
                verdicts: number;
                compared: number;
                differences: number;
            };
            /** @description Of the report of a test that is withdrawn: true. */
            withdrawn?: boolean;
            /** @description Of an issued result: where the audit trail ended before. */
            issue?: {
                trail_head: string;
            };
        };
        Revision: {
            /** @description The version that was looked at; 409 when it is no longer the latest. */
            base_version: number;
            /** @description Empty: as it is. */
            title?: string;
            reason?: string;
            changes?: components["schemas"]["Changes"];
            options?: components["schemas"]["GivenOptions"];
            /** @description None: as it is. */
            plan?: components["schemas"]["Id"] | null;
        };
        /** @description Text above 2^53, which a number of JSON cannot hold. */
        Seed: number | string;
        /** @description Members of an answer that are no part of the thing itself. */
        SentBack: {
            /** @description Passed over. */
            id?: unknown;
            /** @description Passed over. */
            version?: unknown;
            /** @description Passed over. */
            change?: unknown;
            /** @description Passed over. */
            axes?: unknown;
            /** @description Passed over. */
            tests?: unknown;
            /** @description Passed over. */
            latest_test?: unknown;
            /** @description Passed over. */
            latest_of_axes?: unknown;
        };
        Sha256: string;
        /** @description A parameter as people read it, with the uncertainty of record, and what it was held against. */
        Shown: {
            parameter: components["schemas"]["Parameter"];
            /** @description Rounded to what its uncertainty allows. */
            value: string;
            /** @description Of record; empty where its method states the interval alone. */
            U: string;
            /** @description Of record, where it has no U. */
            interval: string;
            unit: string;
            limit: number | null;
            verdict: components["schemas"]["Verdict"] | null;
            /** @description Ends of the stated interval of record, in the native unit. */
            low: number | null;
            high: number | null;
            method: components["schemas"]["Method"] | null;
            /** @description Who stated the limit. */
            source: components["schemas"]["LimitSource"] | null;
            /** @description Limits of the same parameter that this one has taken the place of. */
            replaced: components["schemas"]["ReplacedLimit"][] | null;
            /** @description Why nothing is decided although there is a value; the verdict is then undecided. */
            withheld: string | null;
        };
        /**
         * @description In which deviations are written.
         * @enum {string}
         */
        ShownUnit: "um" | "mm" | "nm" | "deg" | "arcsec";
        /** @description What a capture may listen to; named when the server is started, never by a request. */
        Source: {
            id: string;
            title: string;
            /** @enum {string} */
            kind: "simulator" | "tcp" | "serial";
            /** @description Of the simulator. */
            speeds?: number[];
            /** @description Of the simulator. */
            presets?: {
                id: string;
                title: string;
                sign: string;
            }[];
            /** @description Of the simulator, for captures of lengths. */
            length_presets?: {
                id: string;
                title: string;
                sign: string;
            }[];
            /** @description Of the simulator, for captures of straightness and rotations. */
            motion_presets?: {
                id: string;
                title: string;
                sign: string;
            }[];
        };
        SourceList: {
            sources: components["schemas"]["Source"][];
        };
        StatedUncertainty: {
            u: number;
            /** @description Null where the method states the interval alone. */
            U: number | null;
            low: number;
            high: number;
        };
        /** @description How many lines a station keeps, and the length of the shortest of them. */
        StationKeeps: {
            position_mm: components["schemas"]["Place"];
            reflector_axis: components["schemas"]["Place"];
            lines: number;
            shortest_mm: number;
        };
        StopKey: {
            /**
             * @description The axis stands at the target that is due; that one has no reading; the last reading back.
             * @enum {string}
             */
            key: "take" | "skip" | "undo";
        };
        /**
         * @description What tells the stops: a person, a column that is not 0, the instrument, which sends one reading at each, or a column of positions.
         * @enum {string}
         */
        StopSign: "keys" | "trigger" | "readings" | "position";
        TemperatureSensors: {
            /** @description Their names, in the order of the log's columns. */
            sensors: string[];
        };
        Test: {
            id: components["schemas"]["Id"];
            version: number;
            latest: number;
            title: string;
            file: {
                name: string;
                sha256: components["schemas"]["Sha256"];
                size: number;
                format: string;
                /** @description Of a file of many; else empty. */
                name_in_file: string;
                /** @description By which the file is read, where it was sent with one; the same for all versions. */
                profile: components["schemas"]["ImportProfile"] | null;
            };
            received: components["schemas"]["Change"];
            /** @description Oldest first. */
            versions: components["schemas"]["TestVersion"][];
            withdrawn: boolean;
            machine: components["schemas"]["Reference"] | null;
            axis: {
                id: components["schemas"]["Id"];
                name: string;
                kind: components["schemas"]["AxisKind"];
                limits: components["schemas"]["Limit"][];
            } | null;
            instruments: {
                id: components["schemas"]["Id"];
                name: string;
                calibration_due: string;
            }[];
            plan: components["schemas"]["Id"] | null;
            changes: components["schemas"]["Changes"];
            options: components["schemas"]["Options"];
            documents: components["schemas"]["Document"][];
        } & components["schemas"]["Evaluated"];
        TestPage: {
            tests: components["schemas"]["TestRow"][];
            /** @description Without limit and offset. */
            total: number;
        };
        TestRow: {
            id: components["schemas"]["Id"];
            version: number;
            title: string;
            file_name: string;
            machine: components["schemas"]["Reference"] | null;
            axis: {
                id: components["schemas"]["Id"];
                name: string;
                kind: components["schemas"]["AxisKind"];
            } | null;
            unit: components["schemas"]["Unit"];
            measured_on: string;
            received_at: string;
            conforming: boolean;
            withdrawn: boolean;
            verdict: components["schemas"]["Verdict"] | null;
            label: string;
            /** @description A, E, R and B, as far as there are; of a test of one direction A_up or A_down, and so on, in their place. */
            figures: components["schemas"]["FigureOfTest"][];
        };
        TestVersion: {
            /** Format: date-time */
            at: string;
            actor: string;
            reason: string;
            version: number;
        };
        TrackingAdvice: {
            /** @description Of the seven that were asked for. */
            lines: number;
            now: components["schemas"]["StationKeeps"];
            /** @description Places that keep more lines, or a longer shortest one. */
            better: {
                position_mm: components["schemas"]["Place"];
                reflector_axis: components["schemas"]["Place"];
                lines: number;
                shortest_mm: number;
                /** @description Higher or lower than the station given stands. */
                raised: boolean;
            }[];
        };
        TrackingDraft: {
            plan: components["schemas"]["TrackingPlanFile"];
            /** @description With the seed and the date, so that it makes the same plan again; null of a plan that was given. */
            request: components["schemas"]["TrackingRequest"] | null;
            duration_s: number;
            /** @description Where the reflector may stand. */
            reach: {
                lowest_mm: components["schemas"]["Place"];
                highest_mm: components["schemas"]["Place"];
            };
            /** @description In the order in which they are driven. */
            lines: components["schemas"]["TrackingLine"][];
            lost: components["schemas"]["LostLine"][];
            remarks: string[];
            /** @description Of the reflector, from line to line. */
            way_mm: components["schemas"]["Place"][];
        };
        /** @description As `axiometry tracking evaluate --json` writes it; docs/results.md explains it. */
        TrackingEvaluation: {
            /** @description In a report of what was withdrawn: true; else left out. */
            withdrawn?: boolean;
            /** @constant */
            result: "tracking-evaluation";
            machine: string;
            setup: components["schemas"]["TrackingPlanFile"]["setup"];
            lines: components["schemas"]["EvaluatedLine"][];
            iso230_6: {
                standard: string;
                lines: string[];
                E: {
                    line: string;
                    value_um: number;
                } | null;
                R: {
                    line: string;
                    value_um: number;
                } | null;
                B: {
                    line: string;
                    value_um: number;
                } | null;
                /** @description Squareness of each face whose two diagonals were measured. */
                face_pairs: {
                    /** @enum {string} */
                    face: "XY" | "XZ" | "YZ";
                    lines: string[];
                    slope_difference_um_per_m: number;
                    /** @enum {string} */
                    squareness: "C0Y" | "B0Z" | "A0Z";
                    um_per_m: number;
                    /** @description Standard. */
                    u_um_per_m: number | null;
                    /** @description Of U for 95.45 %, Student's t; 2 where a kept result has none. */
                    k?: number | null;
                }[];
            };
            squareness: {
                terms: {
                    id: string;
                    um_per_m: number | null;
                    u_um_per_m: number | null;
                    /** @description Of U for 95.45 %, Student's t; 2 where a kept result has none. */
                    k?: number | null;
                }[];
                rank: number;
                degrees_of_freedom: number;
                chi_squared: number | null;
                residuals_um_per_m: number[];
                notes: string[];
            } | null;
            findings: components["schemas"]["TrackingFinding"][];
            source: {
                file: string;
                sha256: components["schemas"]["Sha256"];
                format: string;
                plan: {
                    file: string;
                    sha256: components["schemas"]["Sha256"];
                };
                station: {
                    file: string;
                    sha256: components["schemas"]["Sha256"];
                } | null;
            };
            program: components["schemas"]["Program"];
        };
        TrackingFinding: {
            /** @description Stable. */
            id: string;
            /** @enum {string} */
            severity: "serious" | "note";
            message: string;
        };
        TrackingLine: {
            id: string;
            standard: string;
            /** @description Where the reflector stands at them, mm. */
            targets: components["schemas"]["Place"][];
            runs: number;
            readings: number;
            /** @description What of the line the instrument can measure, by the distance from the station; null of a diagonal of the travels. */
            usable: {
                octant: string;
                begin_mm: number;
                end_mm: number;
                limited_by_begin: string;
                limited_by_end: string;
            } | null;
        };
        /** @description A test of several lines in space with a tracking interferometer. */
        TrackingPlanFile: {
            /** @constant */
            format: "axiometry-tracking-plan/1";
            /** @description Which test this is. */
            title?: string | null;
            /** @description Name of the machine. */
            machine?: string | null;
            /** @description Date on which the plan was made. */
            date?: string | null;
            /** @description Machine, instrument and what stands about. Without a station: an interferometer that is aligned with each line in turn. */
            setup: {
                /** @description Where the axes may stand. */
                travel: {
                    /** @description Corner with the lowest X, Y, Z. */
                    lowest_mm: number[];
                    /** @description Corner with the highest X, Y, Z. */
                    highest_mm: number[];
                };
                /** @description From where the axes stand to the centre of the reflector. */
                tool_offset_mm?: number[];
                /** @description The place of the instrument. */
                station?: {
                    /** @description Where the instrument stands, in the reflector's coordinates. */
                    position_mm: number[];
                    /** @description Covariance of the station; absent when nothing is known about it. */
                    covariance_mm2?: number[][] | null;
                };
                /** @description What instrument and reflector can do. */
                limits?: {
                    /** @description Shortest distance of the instrument. */
                    range_least_mm?: number | null;
                    /** @description Longest distance of the instrument. */
                    range_most_mm?: number | null;
                    /** @description Of the beam above the plane of X and Y. */
                    elevation_lowest_deg?: number | null;
                    /** @description Of the beam above the plane of X and Y. */
                    elevation_highest_deg?: number | null;
                    /** @description Where the reflector looks, from the spindle. */
                    reflector_axis?: number[];
                    /** @description Between the beam and the reflector's axis. */
                    incidence_most_deg?: number | null;
                    /** @description Nothing of the machine comes nearer to the station. */
                    safe_radius_mm?: number | null;
                    /** @description A shorter line is not worth a test. */
                    line_least_mm?: number | null;
                };
                /** @description Expanded uncertainty (k = 2) of a length L: a + b·L. */
                ranging?: {
                    /** @description a, in µm. */
                    constant_um?: number | null;
                    /** @description b, in µm/m. */
                    per_length_um_per_m?: number | null;
                };
                /** @description What stands in the way of reflector and beam. */
                obstacles?: {
                    /** @description What it is. */
                    name?: string | null;
                    /** @description With edges along X, Y, Z. */
                    box?: {
                        /** @description Corner with the lowest X, Y, Z. */
                        lowest_mm: number[];
                        /** @description Corner with the highest X, Y, Z. */
                        highest_mm: number[];
                    };
                    /** @description A ball. */
                    sphere?: {
                        /** @description Centre. */
                        centre_mm: number[];
                        /** @description Radius. */
                        radius_mm: number | null;
                    };
                    /** @description Upright, along Z. */
                    cylinder?: {
                        /** @description Middle of the lower end. */
                        base_mm: number[];
                        /** @description Radius. */
                        radius_mm: number | null;
                        /** @description Height. */
                        height_mm: number | null;
                    };
                }[] | null;
            };
            lines: {
                /** @description Such as xy or NNN-PPP. */
                id: string;
                plan: components["schemas"]["PlanFile"];
            }[];
            /** @description Lines that cannot be measured from this station. */
            lost?: {
                /** @description Of the line. */
                id?: string | null;
                /** @description Why it cannot be measured. */
                reason?: string | null;
            }[] | null;
            /** @description Of the planner, for people. */
            remarks?: string[] | null;
            /** @description Which program wrote the plan; ignored when it is read. */
            program?: Record<string, never> | string | null;
            /** @description For people; ignored when it is read. */
            version?: string | null;
            /** @description For people; ignored when it is read. */
            duration_s?: number | null;
        };
        TrackingPoints: {
            points: {
                axes: components["schemas"]["Place"];
                reflector: components["schemas"]["Place"];
            }[];
            /** @description How well they will find the station. */
            expected: {
                covariance_mm2: components["schemas"]["Matrix"];
                amplification: components["schemas"]["Place"];
                condition_refined: number;
                condition_linear: number;
            };
            remarks: string[];
            /** @description The table to be filled in at the machine, which `/api/tracking/station` reads. */
            csv: string;
        };
        /** @description Either a request or a plan, and the control. */
        TrackingProgramRequest: {
            request?: components["schemas"]["TrackingRequest"];
            plan?: components["schemas"]["TrackingPlanFile"];
            /** @description Of the vocabulary. */
            dialect: string;
            /** @description One line alone; all of them in one program when left out or empty. */
            line?: string;
            /** @description By the names of the query of `/api/plans/{id}/program`. */
            options?: {
                [key: string]: string | number | boolean;
            };
        };
        /** @description What shall be planned with a tracking interferometer. */
        TrackingRequest: {
            setup: components["schemas"]["TrackingPlanFile"]["setup"];
            /** @description Mount the reflector so that it sees the most lines; else as the set-up has it. */
            turn_reflector?: boolean | null;
            /** @description Of x, y, z, xy, xz, yz, xyz, and full diagonals of the travels: body, face, or some such as NNN-PPP. All seven when left out. */
            lines?: string[] | null;
            /**
             * @description Diagonals from the station: equal increments, or towards the corner of the travels.
             * @enum {unknown}
             */
            rule?: "equal" | "corner" | null;
            /** @description Of each line; as the clause asks when left out. */
            targets?: number | null;
            /** @description Approaches to each target from each direction. */
            runs?: number | null;
            overrun_mm?: number | null;
            /** @description mm/min. */
            feed?: number | null;
            dwell_s?: number | null;
            /** @description Of the axes, mm/s². */
            acceleration?: number | null;
            warm_up_runs?: number | null;
            /** @description Expected of periodic errors of X, Y, Z. */
            periods_mm?: (number | null)[] | null;
            /** @description To which coordinates of targets are rounded. */
            step_mm?: number | null;
            /** @description Of the random part of the targets; drawn when left out. */
            seed?: number | null;
            title?: string | null;
            machine?: string | null;
            date?: string | null;
        };
        /** @description As `axiometry tracking locate --json` writes it; docs/howto/find-the-station.md explains it. */
        TrackingStation: {
            /** @constant */
            result: "station-location";
            units: {
                lengths: string;
                covariance: string;
                psi: string;
                misclosure: string;
                equation_residuals: string;
                redundant_residual: string;
            };
            linear: {
                station: components["schemas"]["Place"] | null;
                L0: number | null;
                psi: number | null;
                rank: number;
                numerical_rank: number;
                rank_tolerance: number;
                condition: number;
                singular_values: number[];
                covariance: components["schemas"]["Matrix"] | null;
                residuals: number[] | null;
                equation_residuals: number[] | null;
                redundant_residual: number | null;
                misclosure: number | null;
                misclosure_u: number | null;
            } | null;
            refined: {
                station: components["schemas"]["Place"];
                L0: number;
                covariance: components["schemas"]["Matrix"];
                covariance_stated: components["schemas"]["Matrix"];
                /** @description As wide as a normal station must have it for bounds that hold 95 %: what plans and lines take. */
                covariance_for_bounds: components["schemas"]["Matrix"];
                inflation: number;
                L0_variance: number;
                residuals: number[];
                sigma: number[];
                chi_squared: number;
                degrees_of_freedom: number;
                chance: number;
                condition: number;
                singular_values: number[];
                iterations: number;
                converged: boolean;
            };
            difference: components["schemas"]["Place"] | null;
            difference_u: components["schemas"]["Place"] | null;
            misclosure: number | null;
            critical_surface: string;
            eccentricity: number | null;
            /** @description Another place that the lengths do not rule out. */
            mirror: components["schemas"]["Place"] | null;
            findings: components["schemas"]["TrackingFinding"][];
            points: {
                at: components["schemas"]["Place"];
                length_difference: number;
            }[];
            options: {
                ranging_constant_um: number;
                ranging_per_length_um_per_m: number;
                machine_sigma_um: number;
                near: components["schemas"]["Place"] | null;
                tool_offset: components["schemas"]["Place"];
            };
            source: {
                file: string;
                sha256: components["schemas"]["Sha256"];
            };
            program: components["schemas"]["Program"];
        };
        /** @description Either a request or a plan. */
        TrackingSubject: {
            request?: components["schemas"]["TrackingRequest"];
            plan?: components["schemas"]["TrackingPlanFile"];
        };
        TrackingWish: {
            request: components["schemas"]["TrackingRequest"];
            /** @description Of points, 6 to 50; 8 when left out. */
            count?: number | null;
        };
        Trend: {
            axis: components["schemas"]["Axis"];
            machine: components["schemas"]["Reference"];
            unit: components["schemas"]["Unit"];
            /** @description Oldest first. */
            points: {
                test: components["schemas"]["Id"];
                version: number;
                title: string;
                measured_on: string;
                received_at: string;
                conforming: boolean;
                label: string;
                /** @description Of all limits together, also of parameters that the test does not have. */
                verdict: components["schemas"]["Verdict"] | null;
                figures: components["schemas"]["FigureOfTest"][];
                /** @description Tests of this axis kept of the same bytes: one measurement, which counts once. The one with the most versions stands for all, of equals the first that came. */
                same_bytes: components["schemas"]["Id"][];
            }[];
        };
        Uncertainty: {
            record: components["schemas"]["UncertaintyOfRecord"];
            inputs: components["schemas"]["ResolvedInput"][];
            annex_a: components["schemas"]["ParameterNumbers"] | null;
            gum: components["schemas"]["GumOutputs"] | null;
            monte_carlo: components["schemas"]["MonteCarloOutputs"] | null;
            annex_a_budget?: components["schemas"]["AnnexABudget"];
            gum_budget?: components["schemas"]["GumBudget"];
            monte_carlo_run?: components["schemas"]["MonteCarloRun"];
        };
        /** @description The uncertainty that stands with every result and decides; all others are for comparison. */
        UncertaintyOfRecord: {
            method: components["schemas"]["Method"] | null;
            /** @description By uncertainty.method; else Monte Carlo where it was asked for, else Annex A, else the GUM. */
            chosen: boolean;
            parameters: {
                A: components["schemas"]["StatedUncertainty"] | null;
                A_up: components["schemas"]["StatedUncertainty"] | null;
                A_down: components["schemas"]["StatedUncertainty"] | null;
                E: components["schemas"]["StatedUncertainty"] | null;
                E_up: components["schemas"]["StatedUncertainty"] | null;
                E_down: components["schemas"]["StatedUncertainty"] | null;
                M: components["schemas"]["StatedUncertainty"] | null;
                R: components["schemas"]["StatedUncertainty"] | null;
                R_up: components["schemas"]["StatedUncertainty"] | null;
                R_down: components["schemas"]["StatedUncertainty"] | null;
                B: components["schemas"]["StatedUncertainty"] | null;
                B_mean: components["schemas"]["StatedUncertainty"] | null;
            };
        };
        /**
         * @description Of deviations and parameters: µm on linear axes, seconds of arc on rotary ones.
         * @enum {string}
         */
        Unit: "um" | "arcsec";
        /**
         * @description Decision about a limit, or the worst of several.
         * @enum {string}
         */
        Verdict: "conforms" | "does not conform" | "undecided";
        /** @description What there is to choose from; titles and descriptions in the language of the request. */
        Vocabulary: {
            parameters: {
                key: components["schemas"]["Parameter"];
                symbol: string;
                title: string;
                clause: string;
            }[];
            /** @description Of the metadata. */
            fields: components["schemas"]["Field"][];
            /** @description Of files of measured deviations. */
            formats: {
                id: string;
                title: string;
                extensions: string;
                /** @description Markdown. */
                manual: string;
                writes: boolean;
            }[];
            /** @description Of reports. */
            writers: {
                extension: string;
                title: string;
            }[];
            /** @description Of part programs. */
            dialects: {
                id: string;
                title: string;
                extension: string;
                axes: string;
                has_loops: boolean;
                manual: string;
            }[];
            /** @description Kinds of tracking instruments, whose uncertainty their names stand for. */
            trackers: {
                id: string;
                title: string;
                has_angles: boolean;
            }[];
            corrections: components["schemas"]["Named"][];
            cycles: components["schemas"]["Named"][];
            /** @description Of decisions about limits. */
            rules: components["schemas"]["Named"][];
            /** @description Tables by which controls compensate the errors of a machine. */
            compensations: {
                id: string;
                title: string;
                of_one_tool: boolean;
                manual: string;
            }[];
            diagonals: string[];
        };
        /** @description Over the travel that both were observed in, with the tools that both have. The uncertainty of a difference is that of independent calibrations; without rigid motion it is 0: not stated. */
        VolumetricDifference: {
            nodes: number;
            before: components["schemas"]["VolumetricField"];
            after: components["schemas"]["VolumetricField"];
            tools: {
                tool: string;
                offset_mm: number[];
                as_found: components["schemas"]["FieldSizes"] | null;
                without_rigid_motion: components["schemas"]["FieldSizes"] | null;
            }[];
        };
        /** @description Those of the result that the model is of; what is serious in them is told of all that is made of it. */
        FindingsOfResult: components["schemas"]["VolumetricFinding"][];
        VolumetricDifferenceRequest: {
            before: components["schemas"]["VolumetricModel"];
            findings_before?: components["schemas"]["FindingsOfResult"];
            remarks_before?: components["schemas"]["RemarksOfResult"];
            after: components["schemas"]["VolumetricModel"];
            findings_after?: components["schemas"]["FindingsOfResult"];
            remarks_after?: components["schemas"]["RemarksOfResult"];
            nodes?: number;
        };
        VolumetricDraft: {
            plan: components["schemas"]["VolumetricPlanFile"];
            expected: components["schemas"]["VolumetricExpectation"];
            /** @description Its points as a table with an empty column for the lengths. */
            csv: string;
        };
        /** @description Of a motion that the lengths do not tell there is no node. */
        VolumetricErrors: {
            EXX: components["schemas"]["VolumetricNode"][];
            EYX: components["schemas"]["VolumetricNode"][];
            EZX: components["schemas"]["VolumetricNode"][];
            EAX: components["schemas"]["VolumetricNode"][];
            EBX: components["schemas"]["VolumetricNode"][];
            ECX: components["schemas"]["VolumetricNode"][];
            EXY: components["schemas"]["VolumetricNode"][];
            EYY: components["schemas"]["VolumetricNode"][];
            EZY: components["schemas"]["VolumetricNode"][];
            EAY: components["schemas"]["VolumetricNode"][];
            EBY: components["schemas"]["VolumetricNode"][];
            ECY: components["schemas"]["VolumetricNode"][];
            EXZ: components["schemas"]["VolumetricNode"][];
            EYZ: components["schemas"]["VolumetricNode"][];
            EZZ: components["schemas"]["VolumetricNode"][];
            EAZ: components["schemas"]["VolumetricNode"][];
            EBZ: components["schemas"]["VolumetricNode"][];
            ECZ: components["schemas"]["VolumetricNode"][];
            C0Y: components["schemas"]["VolumetricSquareness"];
            B0Z: components["schemas"]["VolumetricSquareness"];
            A0Z: components["schemas"]["VolumetricSquareness"];
        };
        /** @description What a plan will tell; texts in the language of the request. */
        VolumetricExpectation: {
            stations: {
                [key: string]: number[];
            };
            runs: {
                station: string;
                tool: string;
                points: number;
            }[];
            points: number;
            rank: components["schemas"]["VolumetricRank"];
            /** @description Errors that the lengths will not tell. */
            unseen: string[];
            /** @description Why, in sentences without full stop. */
            reasons: string[];
            /** @description Standard uncertainties of each of the 21 errors, µm or µrad. */
            errors: {
                [key: string]: {
                    u_mean: number | null;
                    u_max: number | null;
                };
            };
            volume: {
                u_rms_um: number | null;
                u_max_um: number | null;
                tools: {
                    [key: string]: {
                        u_rms_um: number | null;
                        u_max_um: number | null;
                    };
                };
            };
            findings: components["schemas"]["VolumetricFinding"][];
        };
        VolumetricField: {
            nodes: number;
            observed_mm: {
                lowest: number[];
                highest: number[];
            };
            findings: components["schemas"]["VolumetricFinding"][];
            tools: {
                tool: string;
                as_found: components["schemas"]["FieldSizes"] | null;
                without_rigid_motion: {
                    largest_um: number;
                    largest_u_um: number;
                    largest_at_mm: number[];
                    mean_um: number;
                    percent_95_um: number;
                    translation_um: number[];
                    rotation_urad: number[];
                } | null;
                diagonals: {
                    [key: string]: components["schemas"]["PredictedLine"] | null;
                };
                offset_mm: number[];
                /** @description At every node, X fastest, from the lowest to the highest place. */
                error_um: (number[] | null)[];
            }[];
        };
        /** @description A serious one says that the result should not be used as it is. */
        VolumetricFinding: {
            /** @description Stable. */
            id: string;
            /** @enum {unknown} */
            severity: "serious" | "note";
            message: string;
        };
        VolumetricForm: {
            /**
             * Format: binary
             * @description A table with the columns station, tool, x_mm, y_mm, z_mm, length_mm and perhaps segment, or a continuous recording; may stand in the form several times.
             */
            lengths: string;
            /**
             * Format: binary
             * @description machine.json; that of the plan without it.
             */
            machine?: string;
            /**
             * Format: binary
             * @description The plan that was driven, which recordings need.
             */
            plan?: string;
            /** @description JSON: ErrorsOptions. */
            options?: string;
        };
        VolumetricLineRequest: {
            model: components["schemas"]["VolumetricModel"];
            findings?: components["schemas"]["FindingsOfResult"];
            remarks?: components["schemas"]["RemarksOfResult"];
            /** @enum {unknown} */
            axis?: "X" | "Y" | "Z";
            /** @description Where the other axes stand; the axis' own does not count. */
            at_mm?: number[];
            /** @description One of Vocabulary.diagonals. */
            diagonal?: string;
            tool?: string;
        };
        /** @description As machine.json of `axiometry volumetric`. Other members are passed over and told. */
        VolumetricMachine: {
            name?: string;
            /** @description From the workpiece to the tool, as XFYZ: axes before F carry the workpiece. */
            chain: string;
            travel_mm: {
                X: number[];
                Y: number[];
                Z: number[];
            };
            /** @description From where the axes stand to the centre of the reflector. */
            tools_mm: {
                [key: string]: number[];
            };
            stations_mm?: {
                [key: string]: number[];
            };
            instrument?: {
                a_um?: number;
                b_um_per_m?: number;
                scale_u_um_per_m?: number | null;
            };
            repeatability_um?: number;
            functional_point_mm?: {
                X?: number[];
                Y?: number[];
                Z?: number[];
            };
        };
        /** @description Machine, curves, coefficients and their covariance: the member `model` of a result file. What is computed from errors is computed from it. */
        VolumetricModel: Record<string, never>;
        VolumetricModelGiven: {
            model: components["schemas"]["VolumetricModel"];
            findings?: components["schemas"]["FindingsOfResult"];
            remarks?: components["schemas"]["RemarksOfResult"];
            /** @description Along each axis, 11 when not given. */
            nodes?: number;
        };
        /** @description Of an error motion: position in mm, value and standard uncertainty in µm or µrad. */
        VolumetricNode: {
            position: number;
            value: number;
            u: number;
            up?: {
                value: number | null;
                u: number | null;
            };
            down?: {
                value: number | null;
                u: number | null;
            };
        };
        /** @description Where the instrument stands in turn, and with each station and tool the places at which a length is read: what 'axiometry volumetric plan' writes, and 'nc' and 'volumetric simulate' read. */
        VolumetricPlanFile: {
            /** @constant */
            format: "axiometry-volumetric-plan/1";
            /** @description On which it was made, as 2026-11-21. */
            date?: string;
            /** @description As machine.json of 'axiometry volumetric identify', with the stations. */
            machine: {
                /** @description From the workpiece to the tool: XFYZ. */
                chain: string;
                /** @description Where the axes may stand. */
                travel_mm: {
                    X: number[];
                    Y: number[];
                    Z: number[];
                };
                /** @description From where the axes stand to the centre of the reflector. */
                tools_mm: {
                    [key: string]: number[];
                };
                /** @description Where the instrument stands, in the reflector's coordinates. */
                stations_mm: {
                    [key: string]: number[];
                };
            };
            /** @description What instrument and reflector can do. */
            limits?: {
                /** @description Shortest distance of the instrument. */
                range_least_mm?: number | null;
                /** @description Longest distance of the instrument. */
                range_most_mm?: number | null;
                /** @description Of the beam above the plane of X and Y. */
                elevation_lowest_deg?: number | null;
                /** @description Of the beam above the plane of X and Y. */
                elevation_highest_deg?: number | null;
                /** @description Where the reflector looks, from the spindle. */
                reflector_axis?: number[];
                /** @description Between the beam and the reflector's axis. */
                incidence_most_deg?: number | null;
                /** @description Nothing of the machine comes nearer to the station. */
                safe_radius_mm?: number | null;
                /** @description A shorter line is not worth a test. */
                line_least_mm?: number | null;
            };
            /** @description What stands in the way of reflector and beam. */
            obstacles?: {
                /** @description What it is. */
                name?: string | null;
                /** @description With edges along X, Y, Z. */
                box?: {
                    /** @description Corner with the lowest X, Y, Z. */
                    lowest_mm: number[];
                    /** @description Corner with the highest X, Y, Z. */
                    highest_mm: number[];
                };
                /** @description A ball. */
                sphere?: {
                    /** @description Centre. */
                    centre_mm: number[];
                    /** @description Radius. */
                    radius_mm: number | null;
                };
                /** @description Upright, along Z. */
                cylinder?: {
                    /** @description Middle of the lower end. */
                    base_mm: number[];
                    /** @description Radius. */
                    radius_mm: number | null;
                    /** @description Height. */
                    height_mm: number | null;
                };
            }[] | null;
            /** @description Between stops. */
            feed_mm_per_min?: number;
            /** @description At rest on every stop. */
            dwell_s?: number;
            /** @description One for each station and tool, in the order of measurement. */
            runs: {
                /** @description Name of a station. */
                station: string;
                /** @description Name of a tool. */
                tool: string;
                /** @description In the order in which they are driven to. */
                stops: {
                    /** @description Where the axes stand when a length is read. */
                    at_mm: number[];
                    /** @description In order, from the stop before; straight when absent. */
                    over_mm?: number[][];
                    /** @description Whether the beam is kept on the way to it (true). */
                    beam_kept?: boolean;
                }[];
            }[];
            /** @description That wrote it. */
            program?: string;
            /** @description Of that program. */
            version?: string;
        };
        /** @description A volumetric calibration that is to be planned. The same request makes the same plan; its date is today's unless it is given. */
        VolumetricPlanRequest: {
            machine: components["schemas"]["VolumetricMachine"];
            /** @description Else those of the machine, which are taken too where it has some and this is left out. */
            propose_stations?: boolean;
            /** @description How many to propose. */
            stations?: number;
            /** @description Of each station and tool; 12 000 in all. */
            points?: number;
            /** @description Where the instrument may stand. */
            room_mm?: {
                X: number[];
                Y: number[];
                Z: number[];
            };
            date?: string;
            limits?: components["schemas"]["TrackingPlanFile"]["setup"]["limits"];
            obstacles?: components["schemas"]["TrackingPlanFile"]["setup"]["obstacles"];
            feed_mm_per_min?: number;
            dwell_s?: number;
        };
        VolumetricPrediction: {
            line: string;
            tool: string;
            prediction: components["schemas"]["PredictedLine"];
            findings: components["schemas"]["VolumetricFinding"][];
        };
        /** @description options.part says which run: one station with one tool. */
        VolumetricProgramRequest: {
            plan: components["schemas"]["VolumetricPlanFile"];
            dialect: string;
            /** @description By the names of the query of `/api/plans/{id}/program`. */
            options?: {
                [key: string]: string | number | boolean;
            };
        };
        VolumetricRank: {
            unknowns: number;
            errors: number;
            rank: number;
            null_directions: number;
            condition: number;
        };
        /** @description As `axiometry volumetric identify --out` writes it; docs/results.md explains it. Texts in the language of the request. */
        VolumetricResult: {
            /** @description In a report of what was withdrawn: true; else left out. */
            withdrawn?: boolean;
            source?: {
                /** @description Name of the file, where there is one. */
                lengths?: string;
                lengths_sha256?: components["schemas"]["Sha256"];
                files: {
                    file: string;
                    sha256: components["schemas"]["Sha256"];
                    /** @description How many were taken of it. */
                    lengths: number;
                    /** @description The layout of a continuous recording. */
                    recording?: string;
                    /** @description Of the plan. */
                    first_part?: number;
                    last_part?: number;
                    /** @description That the plan has in these parts. */
                    stops?: number;
                }[];
                /** @description Name of the file that describes the machine. */
                machine: string;
                machine_sha256: components["schemas"]["Sha256"];
                plan?: string;
                plan_sha256?: components["schemas"]["Sha256"];
            };
            errors: components["schemas"]["VolumetricErrors"];
            /** @description By which of many equal sets of errors the one that is stated was chosen. */
            gauge?: {
                chain: string;
                means: string;
                straightness: string;
                /** @description Of each axis, over which means and straight lines are taken. */
                range_mm: {
                    [key: string]: number[];
                };
                /** @description Of each axis. */
                functional_point_mm: {
                    [key: string]: number[];
                };
            };
            rank: components["schemas"]["VolumetricRank"];
            unseen: string[];
            chi2_per_dof: number | null;
            chi2?: number;
            degrees_of_freedom: number;
            variance_factor?: number;
            readings: number;
            stations: {
                station: string;
                tool: string;
                position_mm: number[];
                covariance_um2?: number[][];
                readings: number;
                rms_um: number;
                normalised_rms: number;
                scale_um_per_m?: number;
                scale_u_um_per_m?: number;
                segments?: {
                    segment: string;
                    readings: number;
                    dead_path_mm: number;
                    drift_um?: number;
                }[];
            }[];
            set_aside: {
                reading: number;
                line?: number;
                station: string;
                tool: string;
                residual_um: number;
                normalised: number;
                /** @enum {string} */
                why: "outlier" | "beside a break" | "unknown direction";
            }[];
            breaks: {
                reading: number;
                line?: number;
                station: string;
                tool: string;
                jump_um: number;
                earliest_reading: number;
                latest_reading: number;
            }[];
            drift?: boolean;
            /** @description Null where curves were not taken to be smooth. */
            smoothness?: {
                /** @description Else as the lengths let it appear. */
                stated: boolean;
                /** @description Null where no such error is smoothed. */
                displacement_um: number | null;
                rotation_urad: number | null;
                /** @description Of the degrees of freedom, those that smoothness takes up. */
                unknowns_told_by_it: number;
                /** @description By name. */
                errors: {
                    [key: string]: {
                        u_ratio: number;
                        bias: number;
                        bend_ratio: number;
                        chance: number;
                    };
                };
            } | null;
            /** @description Null where it was not looked for, or parts, a station with a tool each, differ in scale no more than chance lets them in four of five calibrations. */
            part_scales?: {
                /** @description Standard deviation of a part. */
                spread_um_per_m: number;
                /** @description That scatter alone lets them differ so much. */
                chance: number;
                /** @description Taken out, and in all uncertainties. */
                held: boolean;
                /** @description Where a scale moves nothing. */
                about_mm: number[];
            } | null;
            findings: components["schemas"]["VolumetricFinding"][];
            model: components["schemas"]["VolumetricModel"];
        };
        VolumetricResultGiven: {
            result: components["schemas"]["VolumetricResult"] | components["schemas"]["VolumetricAssembly"];
        };
        /** @description µrad; null where the lengths do not tell it. */
        VolumetricSquareness: {
            value: number | null;
            u: number | null;
        };
        VolumetricSubject: {
            plan: components["schemas"]["VolumetricPlanFile"];
        };
        /** @description Serious findings of the result stand in the first line of the file, by name. */
        VolumetricTableRequest: {
            model: components["schemas"]["VolumetricModel"];
            findings?: components["schemas"]["FindingsOfResult"];
            remarks?: components["schemas"]["RemarksOfResult"];
            /** @description One of Vocabulary.compensations. */
            table: string;
            tool?: string;
            nodes?: number;
        };
        VolumetricCompensationRequest: {
            model: components["schemas"]["VolumetricModel"];
            findings?: components["schemas"]["FindingsOfResult"];
            remarks?: components["schemas"]["RemarksOfResult"];
            /**
             * @description The axis at whose positions the table stands.
             * @enum {unknown}
             */
            along: "X" | "Y" | "Z";
            /**
             * @description The direction in which the tool point is moved; left out: `along`.
             * @enum {unknown}
             */
            component?: "X" | "Y" | "Z";
            /** @description May be left out where the machine has one. */
            tool?: string;
            /** @description Of a cross table: the axis that is moved, as the control names it; left out: `component`. */
            output_axis?: string;
            options: components["schemas"]["CompensationOptions"];
        };
        /** @description Of the error of the tool point over the volume, µm. */
        VolumetricTableSizes: {
            largest: number;
            percent_95: number;
            mean: number;
        };
        VolumetricCompensation: {
            file_name: string;
            /** @description The file for the control. */
            table: string;
            result: {
                control: string;
                /** @description As the control names it. */
                axis: string;
                /** @description That is moved. */
                output_axis: string;
                /** @description `EXY, C0Y` */
                errors: string;
                unit: components["schemas"]["Unit"];
                sign: string;
                /** @description Whether that is the other one than was inferred of the control. */
                turned_sign: boolean;
                table: components["schemas"]["CompensationNode"][];
                /** @description Range of the displacements on the line through the middle, µm; u: the largest standard uncertainty of one. */
                line_range: {
                    before: number;
                    after: number;
                    u: number;
                };
                volume: {
                    before: components["schemas"]["VolumetricTableSizes"];
                    after: components["schemas"]["VolumetricTableSizes"];
                };
                findings: components["schemas"]["VolumetricFinding"][];
            };
        };
        MultilaterationForm: {
            /**
             * Format: binary
             * @description A table with the columns point, station, length_mm, perhaps segment, and x_mm, y_mm, z_mm of the nominal points here or in `points`.
             */
            ranges: string;
            /**
             * Format: binary
             * @description Nominal points: point, x_mm, y_mm, z_mm.
             */
            points?: string;
            /** @description JSON. */
            options?: string;
        };
        MultilaterationOptions: {
            /**
             * @description Of the lengths: known, one unknown, one unknown of each station.
             * @default fixed
             * @enum {string}
             */
            scale: "fixed" | "common" | "free";
            /** @description Standard uncertainty of an unknown scale about 1, in 10⁻⁶. */
            scale_prior_ppm?: number;
            /** @description `0.2um+0.3um/m`: U = a + b·L of the instrument (k = 2), or the name of a kind of instrument. */
            ranging?: string;
            /** @description `0.5um`: standard uncertainty of the machine between stations along a beam. */
            repeatability?: string;
            /**
             * @description Whether breaks of the beam are looked for that the file does not state.
             * @default true
             */
            find_breaks: boolean;
            /**
             * @description Of the points, with the search for readings that do not fit.
             * @default true
             */
            covariances: boolean;
        };
        /** @description Of a station's lengths, for each segment of its beam. */
        DeadPath: {
            /** @description null where a break begins it that the file does not state. */
            segment: string | null;
            dead_path_mm: number;
            u_mm?: number;
        };
        /** @description A point; its deviation is that from the nominal one. */
        FoundPoint: {
            name: string;
            position_mm: components["schemas"]["Place"];
            deviation_um?: components["schemas"]["Place"];
            covariance_mm2?: components["schemas"]["Matrix"];
        };
        /** @description As `axiometry tracking multilaterate --json` writes it; docs/results.md explains it. Texts in the language of the request. */
        Multilateration: {
            /** @constant */
            result: "multilateration";
            /** @enum {unknown} */
            scale: "fixed" | "common" | "free";
            scale_prior: number | null;
            converged: boolean;
            iterations: number;
            chi_squared: number;
            degrees_of_freedom: number;
            variance_factor: number;
            rank: {
                unknowns: number;
                equations: number;
                gauge: number;
                null_directions: number;
                condition: number;
                weakest_mm: number;
                points_least: number;
                stations_coplanar: boolean;
                stations_off_plane_mm: number;
            };
            stations: {
                name: string;
                position_mm: components["schemas"]["Place"];
                covariance_mm2: components["schemas"]["Matrix"];
                dead_paths: components["schemas"]["DeadPath"][];
                scale: number;
                scale_u: number;
            }[];
            /** @description Of a beam, that the file does not state. */
            breaks: {
                station: string;
                reading: number;
                line: number;
                point: string;
                jump_mm: number;
            }[];
            findings: components["schemas"]["TrackingFinding"][];
            remarks: string[];
            source: {
                file: string;
                sha256: components["schemas"]["Sha256"];
                format: string;
            };
            points_source?: {
                file: string;
                sha256: components["schemas"]["Sha256"];
                format: string;
            };
            program: components["schemas"]["Program"];
            points: components["schemas"]["FoundPoint"][];
            /** @description Of the lengths, in the order of the file. */
            residuals_um: number[];
        };
        PolarForm: {
            /**
             * Format: binary
             * @description A table with the columns point, station, length_mm, azimuth_deg, elevation_deg or zenith_deg, and perhaps their uncertainties; may stand in the form several times.
             */
            readings: string;
            /**
             * Format: binary
             * @description Nominal points: point, x_mm, y_mm, z_mm; coordinates are in theirs.
             */
            points?: string;
            /** @description JSON. */
            options?: string;
        };
        PolarChoices: {
            /** @description `leica-at901`, or `TR=etalon-lasertracer` of one station: whose uncertainty counts where the rows state none. */
            instruments?: string[];
            /** @description `20um+1um/m`: U of lengths (k = 2). */
            ranging?: string;
            /** @description `2arcsec`, or `30um+12um/m` across the beam: U of angles (k = 2). */
            angles?: string;
            /** @description With nominal points too, coordinates are those of the first station with angles. */
            in_station?: boolean;
        };
        /** @description As `axiometry tracking polar --json` writes it; docs/results.md explains it. Texts in the language of the request. */
        PolarResult: {
            /** @constant */
            result: "polar";
            /** @enum {unknown} */
            coordinates: "nominal" | "station";
            equations: number;
            unknowns: number;
            /** @description How many of the unknowns the lengths tell. */
            told_by_lengths: number;
            told_by_angles: number;
            chi_squared: number;
            degrees_of_freedom: number;
            variance_factor: number;
            stations: {
                name: string;
                position_mm: components["schemas"]["Place"];
                covariance_mm2: components["schemas"]["Matrix"];
                has_angles: boolean;
                turn: components["schemas"]["Matrix"] | null;
                dead_paths: components["schemas"]["DeadPath"][];
            }[];
            points: components["schemas"]["FoundPoint"][];
            residuals: {
                point: string;
                station: string;
                length_um: number;
                length_normalised: number;
                sideways_um?: number;
                sideways_normalised?: number;
                upwards_um?: number;
                upwards_normalised?: number;
            }[];
            findings: components["schemas"]["TrackingFinding"][];
            remarks: string[];
            sources: {
                file: string;
                sha256: components["schemas"]["Sha256"];
                format: string;
            }[];
            points_source?: {
                file: string;
                sha256: components["schemas"]["Sha256"];
                format: string;
            };
            program: components["schemas"]["Program"];
        };
        AssemblyForm: {
            /**
             * Format: binary
             * @description What an error was read from: a test of positions in any format, a table of straightness or rotations, or the JSON of a result of these or of squareness; may stand in the form several times.
             */
            errors?: string;
            /**
             * Format: binary
             * @description machine.json.
             */
            machine: string;
            /** @description JSON. */
            options: string;
        };
        AssemblyOptions: {
            /** @description `EYX=straightness.csv`, by the name of a file of the form, or of squareness in µrad with its U (k = 2) `C0Y=-12.5,1.2`. */
            errors: string[];
            /** @description `X=0,300:up,-200:down@T1`: where the axes stood while X was measured, in which direction the others came to rest there, and with which tool. */
            at?: string[];
            /** @description `EYX=0.4,0.5`: U = A + B per metre of the readings of one error (k = 2), µm or µrad. */
            instruments?: string[];
            /**
             * @description Curves of both directions where they were read, or their mean.
             * @default curves
             * @enum {string}
             */
            reversal: "curves" | "none";
        };
        /** @description As `axiometry volumetric assemble --out` writes it; docs/results.md explains it. Texts in the language of the request. */
        VolumetricAssembly: {
            /** @constant */
            result: "volumetric-assembled";
            errors: {
                name: string;
                file: string | null;
                sha256: string | null;
                runs: number | null;
                /** @description Of its readings (k = 1), µm or µrad. */
                u_largest: number;
                /** @enum {unknown} */
                directions: "both" | "up" | "down" | null;
                reversal_largest: number | null;
                instrument: {
                    U_constant: number;
                    U_per_m: number;
                } | null;
                equipment: string | null;
            }[];
            at: {
                X?: components["schemas"]["AssemblyStand"];
                Y?: components["schemas"]["AssemblyStand"];
                Z?: components["schemas"]["AssemblyStand"];
            };
            findings: components["schemas"]["VolumetricFinding"][];
            remarks: string[];
            machine_source: {
                file: string;
                sha256: components["schemas"]["Sha256"];
            };
            curves: components["schemas"]["VolumetricErrors"];
            model: components["schemas"]["VolumetricModel"];
            program: components["schemas"]["Program"];
        };
        AssemblyStand: {
            axes_mm: components["schemas"]["Place"];
            tool: string | null;
            approaches: {
                /** @enum {unknown} */
                X?: "up" | "down";
                /** @enum {unknown} */
                Y?: "up" | "down";
                /** @enum {unknown} */
                Z?: "up" | "down";
            };
        };
        /** @description Those of a VolumetricAssembly, which what is made of it does not hold either. */
        RemarksOfResult: string[];
    };
    responses: never;
    parameters: never;
    requestBodies: never;
    headers: never;
    pathItems: never;
}
export type AnnexABudget = components['schemas']['AnnexABudget'];
export type AnnexAMean = components['schemas']['AnnexAMean'];
export type AppliedCorrection = components['schemas']['AppliedCorrection'];
export type Approach = components['schemas']['Approach'];
export type AskedTable = components['schemas']['AskedTable'];
export type AuditEntry = components['schemas']['AuditEntry'];
export type AuditTrail = components['schemas']['AuditTrail'];
export type Axis = components['schemas']['Axis'];
export type AxisEdit = components['schemas']['AxisEdit'];
export type AxisKind = components['schemas']['AxisKind'];
export type AxisList = components['schemas']['AxisList'];
export type AxisVersions = components['schemas']['AxisVersions'];
export type Calibration = components['schemas']['Calibration'];
export type CalibrationComparison = components['schemas']['CalibrationComparison'];
export type CalibrationFigure = components['schemas']['CalibrationFigure'];
export type CalibrationForm = components['schemas']['CalibrationForm'];
export type CalibrationHead = components['schemas']['CalibrationHead'];
export type CalibrationKind = components['schemas']['CalibrationKind'];
export type CalibrationPage = components['schemas']['CalibrationPage'];
export type CalibrationRevision = components['schemas']['CalibrationRevision'];
export type CalibrationRow = components['schemas']['CalibrationRow'];
export type Capture = components['schemas']['Capture'];
export type CaptureIds = components['schemas']['CaptureIds'];
export type CaptureList = components['schemas']['CaptureList'];
export type CaptureRequest = components['schemas']['CaptureRequest'];
export type CapturedLengths = components['schemas']['CapturedLengths'];
export type CapturedMotion = components['schemas']['CapturedMotion'];
export type CapturedPlan = components['schemas']['CapturedPlan'];
export type CapturedReading = components['schemas']['CapturedReading'];
export type CapturedTable = components['schemas']['CapturedTable'];
export type Change = components['schemas']['Change'];
export type Changes = components['schemas']['Changes'];
export type Claim = components['schemas']['Claim'];
export type Counts = components['schemas']['Counts'];
export type Cycle = components['schemas']['Cycle'];
export type Direction = components['schemas']['Direction'];
export type Document = components['schemas']['Document'];
export type Draft = components['schemas']['Draft'];
export type Drift = components['schemas']['Drift'];
export type EditNote = components['schemas']['EditNote'];
export type Entity = components['schemas']['Entity'];
export type ErrorKind = components['schemas']['ErrorKind'];
export type ErrorsOptions = components['schemas']['ErrorsOptions'];
export type Evaluated = components['schemas']['Evaluated'];
export type EvaluatedLine = components['schemas']['EvaluatedLine'];
export type EvaluationForm = components['schemas']['EvaluationForm'];
export type ExamplesLoaded = components['schemas']['ExamplesLoaded'];
export type Expanded = components['schemas']['Expanded'];
export type ExpansionCorrection = components['schemas']['ExpansionCorrection'];
export type ExpansionPart = components['schemas']['ExpansionPart'];
export type FactorUncertainty = components['schemas']['FactorUncertainty'];
export type Failure = components['schemas']['Failure'];
export type Field = components['schemas']['Field'];
export type FieldSizes = components['schemas']['FieldSizes'];
export type FigureList = components['schemas']['FigureList'];
export type FigureOfTest = components['schemas']['FigureOfTest'];
export type FileForm = components['schemas']['FileForm'];
export type Finding = components['schemas']['Finding'];
export type FromArchive = components['schemas']['FromArchive'];
export type GivenOptions = components['schemas']['GivenOptions'];
export type GivenPlanRequest = components['schemas']['GivenPlanRequest'];
export type GumBudget = components['schemas']['GumBudget'];
export type GumOutput = components['schemas']['GumOutput'];
export type GumOutputs = components['schemas']['GumOutputs'];
export type Health = components['schemas']['Health'];
export type HealthStatus = components['schemas']['HealthStatus'];
export type Id = components['schemas']['Id'];
export type ImportProfile = components['schemas']['ImportProfile'];
export type Instrument = components['schemas']['Instrument'];
export type InstrumentEdit = components['schemas']['InstrumentEdit'];
export type InstrumentList = components['schemas']['InstrumentList'];
export type InstrumentVersions = components['schemas']['InstrumentVersions'];
export type Interval = components['schemas']['Interval'];
export type Language = components['schemas']['Language'];
export type IssueRequest = components['schemas']['IssueRequest'];
export type Judged = components['schemas']['Judged'];
export type Judgement = components['schemas']['Judgement'];
export type CompensatedControl = components['schemas']['CompensatedControl'];
export type CompensationLimits = components['schemas']['CompensationLimits'];
export type CompensationMean = components['schemas']['CompensationMean'];
export type CompensationRetest = components['schemas']['CompensationRetest'];
export type CompensationPeriodic = components['schemas']['CompensationPeriodic'];
export type CompensationKnown = components['schemas']['CompensationKnown'];
export type CompensationKnownMean = components['schemas']['CompensationKnownMean'];
export type CompensationBetween = components['schemas']['CompensationBetween'];
export type CompensationPeriodicWay = components['schemas']['CompensationPeriodicWay'];
export type CompensationResult = components['schemas']['CompensationResult'];
export type CompensationOptions = components['schemas']['CompensationOptions'];
export type CompensationNode = components['schemas']['CompensationNode'];
export type CompensationForm = components['schemas']['CompensationForm'];
export type KeptOptions = components['schemas']['KeptOptions'];
export type LinesOptions = components['schemas']['LinesOptions'];
export type MotionOptions = components['schemas']['MotionOptions'];
export type RecordingOptions = components['schemas']['RecordingOptions'];
export type TableForm = components['schemas']['TableForm'];
export type ReadTable = components['schemas']['ReadTable'];
export type MadeCompensation = components['schemas']['MadeCompensation'];
export type RuleFigure = components['schemas']['RuleFigure'];
export type ComparedFigure = components['schemas']['ComparedFigure'];
export type RuleOfComparison = components['schemas']['RuleOfComparison'];
export type ComparedRule = components['schemas']['ComparedRule'];
export type ComparisonOfRules = components['schemas']['ComparisonOfRules'];
export type RulesCompared = components['schemas']['RulesCompared'];
export type RulesReport = components['schemas']['RulesReport'];
export type FittedValue = components['schemas']['FittedValue'];
export type PeriodicDirection = components['schemas']['PeriodicDirection'];
export type PeriodicError = components['schemas']['PeriodicError'];
export type PeriodicReport = components['schemas']['PeriodicReport'];
export type PeriodicShown = components['schemas']['PeriodicShown'];
export type ReportDocument = components['schemas']['ReportDocument'];
export type TextRun = components['schemas']['TextRun'];
export type ReportCell = components['schemas']['ReportCell'];
export type ReportNotice = components['schemas']['ReportNotice'];
export type ReportTable = components['schemas']['ReportTable'];
export type ReportFigure = components['schemas']['ReportFigure'];
export type ReportBlock = components['schemas']['ReportBlock'];
export type CalibrationResult = components['schemas']['CalibrationResult'];
export type CompensationFigure = components['schemas']['CompensationFigure'];
export type CompensationTest = components['schemas']['CompensationTest'];
export type CompensationHead = components['schemas']['CompensationHead'];
export type CompensationList = components['schemas']['CompensationList'];
export type KeptCompensation = components['schemas']['KeptCompensation'];
export type CompensationRevision = components['schemas']['CompensationRevision'];
export type KeptCalibration = components['schemas']['KeptCalibration'];
export type KeptTemperatures = components['schemas']['KeptTemperatures'];
export type RecordedShare = components['schemas']['RecordedShare'];
export type Surroundings = components['schemas']['Surroundings'];
export type DrawnMean = components['schemas']['DrawnMean'];
export type LengthPart = components['schemas']['LengthPart'];
export type LengthParts = components['schemas']['LengthParts'];
export type LengthPlan = components['schemas']['LengthPlan'];
export type LengthPlanKind = components['schemas']['LengthPlanKind'];
export type LengthSubject = components['schemas']['LengthSubject'];
export type Limit = components['schemas']['Limit'];
export type LimitSource = components['schemas']['LimitSource'];
export type LocateOptions = components['schemas']['LocateOptions'];
export type Login = components['schemas']['Login'];
export type LostLine = components['schemas']['LostLine'];
export type Machine = components['schemas']['Machine'];
export type MachineEdit = components['schemas']['MachineEdit'];
export type MachineList = components['schemas']['MachineList'];
export type MachineVersion = components['schemas']['MachineVersion'];
export type MachineVersions = components['schemas']['MachineVersions'];
export type Matrix = components['schemas']['Matrix'];
export type Measurand = components['schemas']['Measurand'];
export type Metadata = components['schemas']['Metadata'];
export type Method = components['schemas']['Method'];
export type MonteCarloOutput = components['schemas']['MonteCarloOutput'];
export type MonteCarloOutputs = components['schemas']['MonteCarloOutputs'];
export type MonteCarloRun = components['schemas']['MonteCarloRun'];
export type MotionCourse = components['schemas']['MotionCourse'];
export type MotionEstimate = components['schemas']['MotionEstimate'];
export type DynamicCurve = components['schemas']['DynamicCurve'];
export type DynamicExtreme = components['schemas']['DynamicExtreme'];
export type DynamicExtremes = components['schemas']['DynamicExtremes'];
export type DynamicOptions = components['schemas']['DynamicOptions'];
export type DynamicResult = components['schemas']['DynamicResult'];
export type DynamicSpectrum = components['schemas']['DynamicSpectrum'];
export type DynamicStretch = components['schemas']['DynamicStretch'];
export type MotionForm = components['schemas']['MotionForm'];
export type MotionOfFile = components['schemas']['MotionOfFile'];
export type MotionResult = components['schemas']['MotionResult'];
export type Named = components['schemas']['Named'];
export type Nothing = components['schemas']['Nothing'];
export type Options = components['schemas']['Options'];
export type Parameter = components['schemas']['Parameter'];
export type ParameterNumbers = components['schemas']['ParameterNumbers'];
export type Place = components['schemas']['Place'];
export type Plan = components['schemas']['Plan'];
export type PlanDraft = components['schemas']['PlanDraft'];
export type PlanEdit = components['schemas']['PlanEdit'];
export type PlanFile = components['schemas']['PlanFile'];
export type PlanList = components['schemas']['PlanList'];
export type PlanPart = components['schemas']['PlanPart'];
export type PlanRequest = components['schemas']['PlanRequest'];
export type PlanRow = components['schemas']['PlanRow'];
export type PlanSubject = components['schemas']['PlanSubject'];
export type PlanVersions = components['schemas']['PlanVersions'];
export type PositionComponents = components['schemas']['PositionComponents'];
export type PositionResult = components['schemas']['PositionResult'];
export type PredictedLine = components['schemas']['PredictedLine'];
export type Preview = components['schemas']['Preview'];
export type PreviewedTest = components['schemas']['PreviewedTest'];
export type Problem = components['schemas']['Problem'];
export type Program = components['schemas']['Program'];
export type ProgramRequest = components['schemas']['ProgramRequest'];
export type Readings = components['schemas']['Readings'];
export type Reason = components['schemas']['Reason'];
export type Receipt = components['schemas']['Receipt'];
export type Received = components['schemas']['Received'];
export type Reference = components['schemas']['Reference'];
export type ReplacedLimit = components['schemas']['ReplacedLimit'];
export type ResolvedInput = components['schemas']['ResolvedInput'];
export type ResultSource = components['schemas']['ResultSource'];
export type Result = components['schemas']['Result'];
export type Revision = components['schemas']['Revision'];
export type Seed = components['schemas']['Seed'];
export type SentBack = components['schemas']['SentBack'];
export type Sha256 = components['schemas']['Sha256'];
export type Shown = components['schemas']['Shown'];
export type ShownUnit = components['schemas']['ShownUnit'];
export type Source = components['schemas']['Source'];
export type SourceList = components['schemas']['SourceList'];
export type StatedUncertainty = components['schemas']['StatedUncertainty'];
export type StationKeeps = components['schemas']['StationKeeps'];
export type StopKey = components['schemas']['StopKey'];
export type StopSign = components['schemas']['StopSign'];
export type TemperatureSensors = components['schemas']['TemperatureSensors'];
export type Test = components['schemas']['Test'];
export type TestPage = components['schemas']['TestPage'];
export type TestRow = components['schemas']['TestRow'];
export type TestVersion = components['schemas']['TestVersion'];
export type TrackingAdvice = components['schemas']['TrackingAdvice'];
export type TrackingDraft = components['schemas']['TrackingDraft'];
export type TrackingEvaluation = components['schemas']['TrackingEvaluation'];
export type TrackingFinding = components['schemas']['TrackingFinding'];
export type TrackingLine = components['schemas']['TrackingLine'];
export type TrackingPlanFile = components['schemas']['TrackingPlanFile'];
export type TrackingPoints = components['schemas']['TrackingPoints'];
export type TrackingProgramRequest = components['schemas']['TrackingProgramRequest'];
export type TrackingRequest = components['schemas']['TrackingRequest'];
export type TrackingStation = components['schemas']['TrackingStation'];
export type TrackingSubject = components['schemas']['TrackingSubject'];
export type TrackingWish = components['schemas']['TrackingWish'];
export type Trend = components['schemas']['Trend'];
export type Uncertainty = components['schemas']['Uncertainty'];
export type UncertaintyOfRecord = components['schemas']['UncertaintyOfRecord'];
export type Unit = components['schemas']['Unit'];
export type Verdict = components['schemas']['Verdict'];
export type Vocabulary = components['schemas']['Vocabulary'];
export type VolumetricDifference = components['schemas']['VolumetricDifference'];
export type FindingsOfResult = components['schemas']['FindingsOfResult'];
export type VolumetricDifferenceRequest = components['schemas']['VolumetricDifferenceRequest'];
export type VolumetricDraft = components['schemas']['VolumetricDraft'];
export type VolumetricErrors = components['schemas']['VolumetricErrors'];
export type VolumetricExpectation = components['schemas']['VolumetricExpectation'];
export type VolumetricField = components['schemas']['VolumetricField'];
export type VolumetricFinding = components['schemas']['VolumetricFinding'];
export type VolumetricForm = components['schemas']['VolumetricForm'];
export type VolumetricLineRequest = components['schemas']['VolumetricLineRequest'];
export type VolumetricMachine = components['schemas']['VolumetricMachine'];
export type VolumetricModel = components['schemas']['VolumetricModel'];
export type VolumetricModelGiven = components['schemas']['VolumetricModelGiven'];
export type VolumetricNode = components['schemas']['VolumetricNode'];
export type VolumetricPlanFile = components['schemas']['VolumetricPlanFile'];
export type VolumetricPlanRequest = components['schemas']['VolumetricPlanRequest'];
export type VolumetricPrediction = components['schemas']['VolumetricPrediction'];
export type VolumetricProgramRequest = components['schemas']['VolumetricProgramRequest'];
export type VolumetricRank = components['schemas']['VolumetricRank'];
export type VolumetricResult = components['schemas']['VolumetricResult'];
export type VolumetricResultGiven = components['schemas']['VolumetricResultGiven'];
export type VolumetricSquareness = components['schemas']['VolumetricSquareness'];
export type VolumetricSubject = components['schemas']['VolumetricSubject'];
export type VolumetricTableRequest = components['schemas']['VolumetricTableRequest'];
export type VolumetricCompensationRequest = components['schemas']['VolumetricCompensationRequest'];
export type VolumetricTableSizes = components['schemas']['VolumetricTableSizes'];
export type VolumetricCompensation = components['schemas']['VolumetricCompensation'];
export type MultilaterationForm = components['schemas']['MultilaterationForm'];
export type MultilaterationOptions = components['schemas']['MultilaterationOptions'];
export type DeadPath = components['schemas']['DeadPath'];
export type FoundPoint = components['schemas']['FoundPoint'];
export type Multilateration = components['schemas']['Multilateration'];
export type PolarForm = components['schemas']['PolarForm'];
export type PolarChoices = components['schemas']['PolarChoices'];
export type PolarResult = components['schemas']['PolarResult'];
export type AssemblyForm = components['schemas']['AssemblyForm'];
export type AssemblyOptions = components['schemas']['AssemblyOptions'];
export type VolumetricAssembly = components['schemas']['VolumetricAssembly'];
export type AssemblyStand = components['schemas']['AssemblyStand'];
export type RemarksOfResult = components['schemas']['RemarksOfResult'];
