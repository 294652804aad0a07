;; See an error, look at a name, go to its definition, mend the error, rename, ask for the preview. Each wait is for an event.
(require 'package)
(package-initialize)
(load (expand-file-name "init.el") nil t t)

(defconst deadline 60 "Seconds.")
(setq eglot-connect-timeout deadline
      jsonrpc-default-request-timeout deadline
      make-backup-files nil
      create-lockfiles nil)

(defun wait-for (what condition)
  (let ((end (+ (float-time) deadline)))
    (while (not (funcall condition))
      (when (> (float-time) end) (error "Waited in vain for %s" what))
      (accept-process-output nil 0.005))))

(defun expect (what expected actual)
  (unless (equal expected actual) (error "%s: expected %S, got %S" what expected actual)))

(defun place (text line)
  "Where TEXT first stands in LINE."
  (save-excursion
    (goto-char (point-min))
    (forward-line (1- line))
    (search-forward text (line-end-position))
    (match-beginning 0)))

(defun send-changes ()
  "Eglot sends them when a person pauses; in a batch nobody does."
  (timer-event-handler eglot--change-idle-timer))

(defun errors ()
  (flymake-start)
  (flymake-diagnostics))

(find-file "document.tex")
(run-hooks 'post-command-hook) ; where eglot-ensure connects
(wait-for "the server" #'eglot-current-server)

(wait-for "an error" #'errors)
(expect "number of errors" 1 (length (errors)))
(let ((fault (car (errors))))
  (expect "text of the error" "\\kappa" (buffer-substring-no-properties (flymake-diagnostic-beg fault) (flymake-diagnostic-end fault)))
  (expect "start of the error" (place "\\kappa" 7) (flymake-diagnostic-beg fault))
  (expect "severity" 'eglot-error (flymake-diagnostic-type fault)))

(goto-char (place "\\rho_d" 7))
(let (hover)
  (eglot-hover-eldoc-function (lambda (text &rest _) (setq hover text)))
  (wait-for "the hover" (lambda () hover))
  (unless (string-match-p "ℝ³" hover) (error "No type in: %s" hover)))

(call-interactively #'xref-find-definitions)
(expect "the definition" (place "\\rho_d" 4) (point))

(save-excursion
  (goto-char (point-max))
  (insert "\\begin{equation} \\kappa = 0.3 \\end{equation}\n"))
(send-changes)
(wait-for "the end of the error" (lambda () (not (errors))))

(let ((renamed (string-replace "\\rho_d" "\\sigma" (buffer-string))))
  (eglot-rename "\\sigma")
  (expect "text with the new name" renamed (buffer-string)))

(let* (visited
       (browse-url-browser-function (lambda (url &rest _) (setq visited url))))
  (texbrdf-preview)
  (unless (string-match-p "\\`http://127\\.0\\.0\\.1:[0-9]+/[[:alnum:]_-]+/\\'" visited) (error "No address: %s" visited)))

(set-buffer-modified-p nil)
(eglot-shutdown (eglot-current-server))
