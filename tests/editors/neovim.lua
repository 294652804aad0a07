-- See an error, look at a name, go to its definition, mend the error, rename, ask for the preview. Each wait is for an event.
local kDeadline = 60000 -- ms

local function wait_for(what, condition)
  assert(vim.wait(kDeadline, condition, 5), 'waited in vain for ' .. what)
end

local function expect(what, expected, actual)
  if not vim.deep_equal(expected, actual) then
    error(('%s: expected %s, got %s'):format(what, vim.inspect(expected), vim.inspect(actual)))
  end
end

local function lines()
  return vim.api.nvim_buf_get_lines(0, 0, -1, false)
end

-- The first place of a text: line from 1, byte column from 0, as cursors count.
local function place(text, line)
  return { line, lines()[line]:find(text, 1, true) - 1 }
end

local function hover_text()
  for _, window in ipairs(vim.api.nvim_list_wins()) do
    if vim.api.nvim_win_get_config(window).relative ~= '' then
      return table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, false), '\n')
    end
  end
end

local function session()
  wait_for('an error', function() return #vim.diagnostic.get(0) > 0 end)
  local errors = vim.diagnostic.get(0)
  expect('number of errors', 1, #errors)
  expect('start of the error', place('\\kappa', 7), { errors[1].lnum + 1, errors[1].col })
  expect('length of the error', #'\\kappa', errors[1].end_col - errors[1].col)
  expect('severity', vim.diagnostic.severity.ERROR, errors[1].severity)

  vim.api.nvim_win_set_cursor(0, place('\\rho_d', 7))
  vim.lsp.buf.hover()
  wait_for('the hover window', hover_text)
  assert(hover_text():find('ℝ³', 1, true), 'no type in: ' .. hover_text())

  vim.lsp.buf.definition()
  wait_for('the definition', function() return vim.deep_equal(vim.api.nvim_win_get_cursor(0), place('\\rho_d', 4)) end)

  vim.api.nvim_buf_set_lines(0, 7, 7, false, { '\\begin{equation} \\kappa = 0.3 \\end{equation}' })
  wait_for('the end of the error', function() return #vim.diagnostic.get(0) == 0 end)

  local renamed = {}
  for i, line in ipairs(lines()) do
    renamed[i] = line:gsub('\\rho_d', '\\sigma')
  end
  vim.lsp.buf.rename('\\sigma')
  wait_for('the new name', function() return vim.deep_equal(lines(), renamed) end)
end

-- The command's message says where the preview is.
local function preview()
  local told
  vim.lsp.handlers['window/showMessage'] = function(_, result) told = result.message end
  vim.cmd('TexbrdfPreview')
  wait_for('the address of the preview', function() return told end)
  assert(told:match('^BRDF preview: http://127%.0%.0%.1:%d+/[%w_-]+/$'), told)
end

local passed, fault = xpcall(function() session() preview() end, debug.traceback)
if not passed then
  io.stderr:write(fault, '\ntext:\n', table.concat(lines(), '\n'), '\ndiagnostics:\n', vim.inspect(vim.diagnostic.get(0)), '\n')
end
vim.cmd(passed and 'qall!' or 'cquit 1')
