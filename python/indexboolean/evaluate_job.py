# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: mesh files with names, and an expression; out: a file for each statement, and result.json."""

from .expression_text import ExpressionError, ExpressionText
from .job import JobError, Refusal


def run_evaluate_job(job, text, file_format, **parameters):
    """Writes folder/<name>.<file_format> for each statement, result_<k> for the k-th, from 0 on, if
    it has no name; then folder/result.json.

    job is a LayersJob, whose files' names the text uses. parameters are those of the filter that
    are not named here. Returns (the filter's result map, the messages that it logged). Raises as
    LayersJob.
    """
    try:
        expression = ExpressionText(text, list(job.files))
    except ExpressionError as error:
        raise Refusal(str(error)) from error
    stems = result_names(expression)
    if len(set(stems)) < len(stems):
        raise JobError("two results would have one file; give each statement a name of its own")
    parameters.setdefault("certify_as", "float" if file_format == "stl" else "host")
    try:
        result, messages = job.run(
            "generate_index_boolean_expression", expression=expression.translated, **parameters
        )
    except Refusal as error:
        raise Refusal(expression.explained(str(error))) from error
    files = {}
    for number, stem in enumerate(stems):
        files[f"result_{number}"] = f"{stem}.{file_format}"
        job.save(result[f"result_{number}_layer"], files[f"result_{number}"])
    job.write_record(files, {"expression": text, **result})
    return result, messages


def result_names(expression):
    """The names of the results' files, without their suffix."""
    return [
        name or f"result_{number}" for number, name in enumerate(expression.statement_names())
    ]
